#include <array>

#include "kernel/batch.hpp"
#include "kernel/pair.hpp"
#include "own_colliders/own_colliders.hpp"

namespace manifuzz {
namespace {

template <class Scalar>
Answer collide_as_batch(const PairCase& pair, Scalar tie_bias) {
  const auto placed = clipping::placed_pair<Scalar>(pair);
  kernel::Shapes<Scalar> shapes;
  const std::array<kernel::Placement<Scalar>, 2> bodies{
      {{shapes.add(placed.a), placed.pose_a}, {shapes.add(placed.b), placed.pose_b}}};
  const std::array<kernel::BodyPair, 1> pairs{{{0, 1}}};
  std::array<Manifold<Scalar>, 1> manifolds;
  kernel::collide_pairs(shapes, bodies, pairs, tie_bias, manifolds);
  for (ContactPoint<Scalar>& point : manifolds[0].points) point.position *= placed.local_per_world;
  return manifold_cast<double>(manifolds[0]);
}

Answer collide_as_pair(const PairCase& pair, float tie_bias) {
  const Pose<float> b_in_a = relative_pose(pair.a.pose, pair.b.pose);
  return manifold_cast<double>(kernel::collide(kernel::rows_of(pair.a.polygon),
                                               kernel::rows_of(pair.b.polygon), b_in_a, tie_bias));
}

}  // namespace

Collider make_pair(double tie_bias) {
  return own::collider_of<float>({.name = "pair",
                                  .version = MANIFUZZ_VERSION,
                                  .description = "clip, one pair at a time, a face a lane",
                                  .tie_bias = {tie_bias},
                                  .min_vertices = 1,
                                  .takes_round = true},
                                 collide_as_pair, make_pair);
}

Collider make_batch(double tie_bias) {
  return own::collider_of<float>(
      {.name = "batch",
       .version = MANIFUZZ_VERSION,
       .description = "clip, many pairs at once, one a lane of the widest vectors",
       .tie_bias = {tie_bias},
       .min_vertices = 1,
       .takes_round = true},
      collide_as_batch<float>, make_batch);
}

Collider make_batch64(double tie_bias) {
  return own::collider_of<double>({.name = "batch64",
                                   .version = MANIFUZZ_VERSION,
                                   .description = "clip64, many pairs at once, one a lane",
                                   .tie_bias = {tie_bias},
                                   .min_vertices = 1,
                                   .takes_round = true},
                                  collide_as_batch<double>, make_batch64);
}

}  // namespace manifuzz
