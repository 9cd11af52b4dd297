#include "kernel/round_pairs.hpp"

#include <algorithm>
#include <cmath>

#include "clipping/collide.hpp"

namespace manifuzz::kernel {

template <class Scalar>
Manifold<Scalar> collide_round_pair(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                                    const Pose<Scalar>& b_in_a, Scalar tie_bias) {
  const ConvexPolygon<Scalar> placed = transform(b_in_a, b);
  Manifold<Scalar> manifold = clipping::collide_in_frame(a, placed, tie_bias);
  if (manifold.count > 0) return manifold;
  const auto between_cores =
      static_cast<Scalar>(std::sqrt(clipping::squared_between_outlines(a, placed)));
  manifold.points[0].depth = std::min(a.radius + b.radius - between_cores, Scalar(0));
  return manifold;
}

/// All have both kinds of shapes in common.
template <class Scalar>
void collide_round(const Shapes<Scalar>& shapes,
                   std::span<const typename PairBatch<Scalar>::Pair> pairs, Scalar tie_bias) {
  if (pairs.empty()) return;
  const auto is_circle = [&](const Placement<Scalar>* body) {
    return shapes.kind(body->shape) == kCircle;
  };
  if (std::ranges::all_of(pairs.front().body, is_circle)) {
    PairBatch<Scalar> batch;
    std::ranges::copy(pairs, batch.pair);
    std::fill(batch.pair + pairs.size(), std::end(batch.pair), pairs.back());
    return collide_circles(shapes, batch);
  }
  for (const auto& [body, corners, out] : pairs) {
    *out = collide_round_pair(shapes.polygon(body[0]->shape), shapes.polygon(body[1]->shape),
                              relative_pose(body[0]->pose, body[1]->pose), tie_bias);
  }
}

template Manifold<float> collide_round_pair(const ConvexPolygon<float>&,
                                            const ConvexPolygon<float>&, const Pose<float>&, float);
template Manifold<double> collide_round_pair(const ConvexPolygon<double>&,
                                             const ConvexPolygon<double>&, const Pose<double>&,
                                             double);
template void collide_round(const Shapes<float>&, std::span<const PairBatch<float>::Pair>, float);
template void collide_round(const Shapes<double>&, std::span<const PairBatch<double>::Pair>,
                            double);

}  // namespace manifuzz::kernel
