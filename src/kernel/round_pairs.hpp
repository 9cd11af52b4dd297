#pragma once

#include "geometry/convex_polygon.hpp"
#include "geometry/manifold.hpp"
#include "kernel/shapes.hpp"

namespace manifuzz::kernel {

/// `clipping::collide` of two circles, B standing at `b_in_a`.
Manifold<float> collide_circles(const ShapeRows& a, const ShapeRows& b, const Pose<float>& b_in_a);

/// The faces of greatest separation of shapes of which one is round at least, and one has faces:
/// A's and B's, of those that have some.
struct RoundFaces {
  int face[2] = {0, 0};
  float separation[2] = {0, 0};  ///< lengths, radii left out
};

/// `clipping::collide_in_frame` of such shapes, which no face separates by more than the total
/// radius.
Manifold<float> contact_of_round_pair(const ShapeRows& a, const ShapeRows& b_in_a,
                                      const RoundFaces& found, float tie_bias);

/// How far apart the outlines of their cores are, a length.
float between_outlines(const ShapeRows& a, const ShapeRows& b_in_a);

/// `clipping::collide` of shapes one of which is round, or both are, B standing at `b_in_a`;
/// without points, the first one's depth is minus the gap between them, a length.
template <class Scalar>
Manifold<Scalar> collide_round_pair_or_gap(const ConvexPolygon<Scalar>& a,
                                           const ConvexPolygon<Scalar>& b,
                                           const Pose<Scalar>& b_in_a, Scalar tie_bias);

}  // namespace manifuzz::kernel
