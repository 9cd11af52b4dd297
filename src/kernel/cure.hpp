#pragma once

#include "kernel/packed.hpp"

namespace manifuzz::kernel {

/// One pair of a block, both polygons in A's frame: the rows of each one's corners.
template <class Scalar>
struct ColumnPair {
  const Row<Scalar>* corners[2];
  int column;
  int count[2];
  Scalar total_radius;
};

/// `clipping::deepest_contact` of one pair: the rare pair whose chosen clip misses the overlap is
/// handed back to the clean code, which is compiled apart from the kernels, without their target.
template <class Scalar>
Manifold<Scalar> deepest_contact(const ColumnPair<Scalar>& pair);

}  // namespace manifuzz::kernel
