#pragma once

#include <optional>

#include "judging/bounds.hpp"
#include "oracle/exact/truth.hpp"

namespace manifuzz {

/// What points leave out of a contact, against the right clip of which they leave out least.
struct ExtentLeftOut {
  int points = 0;    ///< of the clip that there must be, less those that there are; at least 0
  double run = 0;    ///< between the clip's ends, a world length; 0 where it need not have both
  double lost = 0;   ///< of that, what is not between the points
  double bound = 0;  ///< how much of that may be rounding

  /// The share of the contact that is left out; none where it has no extent beyond rounding.
  std::optional<double> share() const;
};

/// Of an answer to a pair of mitred polygons that touch, its points in A's frame, whatever its
/// normal. Right is what `admissible` has, but for a bias that asks for an empty clip.
ExtentLeftOut extent_left_out(const exact::Truth& truth, const TieBias& tie_bias,
                              const Bounds& bounds, const Manifold<double>& manifold);

/// Whether a collider of this declaration promises both ends of a contact though no clip gives
/// them.
bool promises_extent(const Declaration& declaration);

}  // namespace manifuzz
