#pragma once

#include "kernel/packed.hpp"
#include "kernel/shapes.hpp"

namespace manifuzz::kernel {

/// One pair of a block, both shapes in A's frame: the rows of each one's corners. Of sharp polygons
/// A's radius may be the sum of both, and B's 0.
template <class Scalar>
struct ColumnPair {
  const Row<Scalar>* corners[2];
  int column;
  int count[2];
  Scalar radius[2];
};

/// `clipping::deepest_contact_or` of one pair: the rare pair whose chosen clip misses the overlap
/// is handed back to the clean code, which is compiled apart from the kernels, without their
/// target.
template <class Scalar>
Manifold<Scalar> deepest_contact_or(const ColumnPair<Scalar>& pair,
                                    const Manifold<Scalar>& clipped);

/// `clipping::collide_in_frame` of one pair with a round shape, in which rounding decides.
template <class Scalar>
Manifold<Scalar> collide_round_column(const ColumnPair<Scalar>& pair, Scalar tie_bias);

/// `manifold`, unless it misses the overlap by `clipping::misses_deepest`: then
/// `clipping::deepest_contact_or`. Both shapes are in A's frame.
Manifold<float> with_deepest_contact(const ShapeRows& a, const ShapeRows& b,
                                     const Manifold<float>& manifold, float separation,
                                     float greatest);

/// `clipping::collide_in_frame`: for the target without vectors, and where signs do not tell.
Manifold<float> collide_cleanly(const ShapeRows& a, const ShapeRows& b, float tie_bias);

}  // namespace manifuzz::kernel
