#pragma once

#include "judging/admissible.hpp"

namespace manifuzz {

/// A manifold from outside, which may leave out what a judge can tell for itself.
struct OutsideManifold {
  Manifold<double> manifold;
  bool names_reference = false;
  bool names_features = false;  ///< of every point
};

/// The manifold with what it leaves out set as the right manifold nearest to it has it, so that
/// nothing is held against it that it did not say.
Manifold<double> completed(const OutsideManifold& given, const Admissible& right);

}  // namespace manifuzz
