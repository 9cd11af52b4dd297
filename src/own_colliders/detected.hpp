#pragma once

#include <optional>

#include "collider/collider.hpp"
#include "methods/cached_points.hpp"

namespace manifuzz::own {

/// B's pose in A's frame, exact but for double's rounding: rotations that are not quite unit are
/// divided by.
Pose<double> exact_b_in_a(const PairCase& pair);

/// The deepest point that a collider answers with, as it is kept; none where there is no contact.
/// What the answer does not name is told by the shapes: the point is on the surface that it is
/// nearer to along the normal, and the normal is of the body that has the likest face.
std::optional<methods::DetectedPoint<double>> detected(const PairCase& pair,
                                                       const Declaration& declaration,
                                                       const Answer& answer);

}  // namespace manifuzz::own
