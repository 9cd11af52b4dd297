#include "kernel/round_pairs.hpp"

#include <algorithm>
#include <cmath>

#include "clipping/collide.hpp"

namespace manifuzz::kernel {

template <class Scalar>
Manifold<Scalar> collide_round_pair(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                                    const Pose<Scalar>& b_in_a, Scalar tie_bias) {
  return clipping::collide(a, b, b_in_a, tie_bias);
}

template <class Scalar>
Manifold<Scalar> collide_round_pair_or_gap(const ConvexPolygon<Scalar>& a,
                                           const ConvexPolygon<Scalar>& b,
                                           const Pose<Scalar>& b_in_a, Scalar tie_bias) {
  const ConvexPolygon<Scalar> placed = transform(b_in_a, b);
  Manifold<Scalar> manifold = clipping::collide_in_frame(a, placed, tie_bias);
  if (manifold.count > 0) return manifold;
  const auto between_cores =
      static_cast<Scalar>(std::sqrt(clipping::squared_between_outlines(a, placed)));
  manifold.points[0].depth = std::min(a.radius + b.radius - between_cores, Scalar(0));
  return manifold;
}

template Manifold<float> collide_round_pair(const ConvexPolygon<float>&,
                                            const ConvexPolygon<float>&, const Pose<float>&, float);
template Manifold<float> collide_round_pair_or_gap(const ConvexPolygon<float>&,
                                                   const ConvexPolygon<float>&, const Pose<float>&,
                                                   float);
template Manifold<double> collide_round_pair_or_gap(const ConvexPolygon<double>&,
                                                    const ConvexPolygon<double>&,
                                                    const Pose<double>&, double);

}  // namespace manifuzz::kernel
