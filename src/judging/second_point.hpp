#pragma once

#include <optional>

#include "judging/by_curve.hpp"

namespace manifuzz {

/// How the second point of a manifold of round shapes falls short: kind `count` where it is missing
/// or there is one too many, `extent` where it spans less of the contact than the nearest right
/// clip; none where it is right. Of an answer whose normal and points are right by the curve.
std::optional<Mismatch> second_point_mismatch(const exact::Truth& truth,
                                              const Declaration& declaration, const Bounds& bounds,
                                              const Manifold<double>& manifold);

}  // namespace manifuzz
