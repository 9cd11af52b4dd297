#pragma once

#include "kernel/pair_stream.hpp"

namespace manifuzz::kernel {

/// `clipping::collide` of shapes one of which is round, or both are; B stands at `b_in_a`.
template <class Scalar>
Manifold<Scalar> collide_round_pair(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                                    const Pose<Scalar>& b_in_a, Scalar tie_bias);

/// As `collide_round_pair`; without points, the first one's depth is minus the gap between them, a
/// length.
template <class Scalar>
Manifold<Scalar> collide_round_pair_or_gap(const ConvexPolygon<Scalar>& a,
                                           const ConvexPolygon<Scalar>& b,
                                           const Pose<Scalar>& b_in_a, Scalar tie_bias);

/// Collides sixteen pairs of circles, equal to `clipping::collide` of each, bit for bit.
void collide_circles(const Shapes<float>& shapes, const PairBatch<float>& batch);
/// Collides sixteen pairs of circles in double.
void collide_circles(const Shapes<double>& shapes, const PairBatch<double>& batch);

}  // namespace manifuzz::kernel
