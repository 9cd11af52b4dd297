#pragma once

#include "geometry/convex_polygon.hpp"
#include "geometry/manifold.hpp"
#include "kernel/shapes.hpp"

namespace manifuzz::kernel {

/// `clipping::collide` of two circles, B standing at `b_in_a`.
Manifold<float> collide_circles(const ShapeRows& a, const ShapeRows& b, const Pose<float>& b_in_a);

/// `clipping::collide` of a circle and a shape with faces, B standing at `b_in_a`.
Manifold<float> collide_circle_and_core(const ShapeRows& a, const ShapeRows& b,
                                        const Pose<float>& b_in_a);

/// `clipping::collide_in_frame` of shapes with faces, one of them round at least, which no face
/// separates by more than the total radius; of A's and of B's, `face` is that of greatest
/// separation.
Manifold<float> contact_of_cores(const ShapeRows& a, const ShapeRows& b_in_a, const int (&face)[2],
                                 float tie_bias);

/// How far apart the outlines of their cores are, a length.
float between_outlines(const ShapeRows& a, const ShapeRows& b_in_a);

/// `clipping::collide` of shapes one of which is round, or both are, B standing at `b_in_a`;
/// without points, the first one's depth is minus the gap between them, a length.
template <class Scalar>
Manifold<Scalar> collide_round_pair_or_gap(const ConvexPolygon<Scalar>& a,
                                           const ConvexPolygon<Scalar>& b,
                                           const Pose<Scalar>& b_in_a, Scalar tie_bias);

}  // namespace manifuzz::kernel
