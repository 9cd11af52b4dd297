#pragma once

#include "collider/sequence_collider.hpp"
#include "judging/by_curve.hpp"

namespace manifuzz {

/// How far what a collider says of its kept points in a frame may be from what is right; bounds.md,
/// "Points kept over frames", derives them.
struct KeptBounds {
  CurveBounds birth;   ///< of a point that is born in the frame, against the penetration curve
  CurveBounds frame;   ///< of a detection in the frame, of which nothing is kept
  double gap = 0;      ///< of a depth against the anchors' gap, and of a drift: world lengths
  double missing = 0;  ///< by how much the deepest point may be too shallow, a world length
  double normal = 0;   ///< of a direction of the world, in this frame: of unit vectors
};

KeptBounds kept_bounds(const exact::Truth& truth, const Declaration& declaration);

/// The bound of a normal against that of an earlier frame, carried: `refreshes` times over.
double carried_normal_bound(const KeptBounds& then, const KeptBounds& now, int refreshes);

/// What is allowed of a length or an angle up to a limit, for the limit is computed too.
double rounded_limit(double limit, const Declaration& declaration);

}  // namespace manifuzz
