#pragma once

#include "geometry/manifold.hpp"

namespace manifuzz::kernel {

/// One pair of a strip, both polygons in A's frame: element e of corner i of polygon p stands
/// `((p * kMaxVertices + i) * 4 + e) * stride` after `corners`; vertex x, y, normal x, y.
template <class Scalar>
struct LanePair {
  const Scalar* corners;
  std::size_t stride;
  int count[2];
  Scalar total_radius;
};

/// `clipping::deepest_contact` of one pair: the rare pair whose chosen clip misses the overlap is
/// handed back to the clean code, which is compiled apart from the kernels, without their target.
template <class Scalar>
Manifold<Scalar> deepest_contact(const LanePair<Scalar>& pair);

}  // namespace manifuzz::kernel
