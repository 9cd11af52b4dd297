#pragma once

#include "kernel/packed.hpp"
#include "scene/roundings.hpp"
#include "scene/shape_table.hpp"

// What a pair was last proven to be, and how far its bodies may move for that to stay proven
// (derived in certificates.md).

namespace manifuzz::scene {

/// A face of one body, the near one, separates the other, far one; or, of a pair that touches, how
/// long its manifold is recycled.
struct Certificate {
  Pose<float> far_in_near;  ///< the far body's pose in the near one's frame, at that moment
  /// The far polygon's vertices may move by less than this, seen from the near one, and the kernel
  /// still finds it separated, or the manifold is still recycled; <= 0: nothing is proven. Length.
  float margin = -1;
  Side near = Side::a;  ///< whose face it is
};

/// The proof that A and B are separated at these poses in the world, by the face that the kernel
/// finds; proves nothing where they are nearer than rounding can tell.
Certificate prove_separated(const ShapeTable& shapes, const kernel::Placement<float>& a,
                            const kernel::Placement<float>& b);

/// Whether the bodies have moved by less than the margin. The shapes are those of the proof.
inline bool still_holds(const Certificate& certificate, const ShapeTable& shapes,
                        const kernel::Placement<float>& a, const kernel::Placement<float>& b) {
  const bool is_a = certificate.near == Side::a;
  const kernel::Placement<float>& near = is_a ? a : b;
  const kernel::Placement<float>& far = is_a ? b : a;
  const float moved = displacement(certificate.far_in_near, relative_pose(near.pose, far.pose),
                                   shapes.facts(far.shape).reach);
  return moved < certificate.margin;
}

}  // namespace manifuzz::scene
