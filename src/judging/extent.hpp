#pragma once

#include <optional>

#include "judging/admissible.hpp"

namespace manifuzz {

/// What points leave out of a contact, against the right clip of which they leave out least.
struct ExtentLeftOut {
  int points = 0;    ///< of the clip that there must be, less those that there are; at least 0
  double run = 0;    ///< between the clip's ends, a world length; 0 where it need not have both
  double lost = 0;   ///< of that, what is not between the points
  double bound = 0;  ///< how much of that may be rounding
  double depth = 0;  ///< of the clip's end that is less deep, a world length

  /// The share of the contact that is left out; none where it has no extent beyond rounding.
  std::optional<double> share() const;
};

/// What an answer to a pair of mitred polygons that touch leaves out, its points in A's frame,
/// whatever its normal. Right is what `admissible` has, but for a bias that asks for an empty clip.
ExtentLeftOut extent_left_out(const exact::Truth& truth, const TieBias& tie_bias,
                              const Bounds& bounds, const Manifold<double>& manifold);

/// How an answer falls short of both ends of a contact where its collider promises them though no
/// clip gives them: kind `count` where one is missing, `extent` where points span less than the
/// nearest right clip. `tolerance` is how far points may be off besides, a world length.
std::optional<Mismatch> extent_mismatch(const exact::Truth& truth, const Declaration& declaration,
                                        const Bounds& bounds, double tolerance,
                                        const Manifold<double>& manifold);

}  // namespace manifuzz
