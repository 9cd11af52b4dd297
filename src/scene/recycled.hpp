#pragma once

#include "geometry/manifold.hpp"
#include "geometry/pose.hpp"

namespace manifuzz::scene {

/// A manifold of B at the pose `from` in A's frame, for B at `to`, with nothing computed anew: its
/// points stay where they are on the incident edge, its normal stays the reference face's, and the
/// depths are those of the points as they moved. What the motion clips, uncovers or separates is
/// not seen, so depths may fall below 0.
Manifold<float> recycled(const Manifold<float>& manifold, const Pose<float>& from,
                         const Pose<float>& to);

}  // namespace manifuzz::scene
