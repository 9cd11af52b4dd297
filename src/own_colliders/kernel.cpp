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

/// With `collide_one(pair, bias)` for its answers.
template <class Scalar, class CollideOne>
Collider implemented(Declaration declaration, CollideOne collide_one) {
  Collider collider;
  declaration.version = MANIFUZZ_VERSION;
  declaration.frame = RoundingFrame::local;
  const auto bias = static_cast<Scalar>(declaration.tie_bias);
  declaration.tie_bias = static_cast<double>(bias);
  collider.declaration = declaration;
  collider.collide = [collide_one, bias](const PairCase& pair) { return collide_one(pair, bias); };
  collider.in_double = [bias] { return make_clip64(static_cast<double>(bias)); };
  return collider;
}

Answer collide_as_pair(const PairCase& pair, float tie_bias) {
  const Pose<float> b_in_a = relative_pose(pair.a.pose, pair.b.pose);
  return manifold_cast<double>(kernel::collide(kernel::rows_of(pair.a.polygon),
                                               kernel::rows_of(pair.b.polygon), b_in_a, tie_bias));
}

}  // namespace

Collider make_pair(double tie_bias) {
  Collider collider = implemented<float>({.name = "pair",
                                          .version = {},
                                          .description = "clip, one pair at a time, a face a lane",
                                          .scalar = ScalarType::float32,
                                          .tie_bias = tie_bias},
                                         collide_as_pair);
  collider.with_tie_bias = make_pair;
  return collider;
}

Collider make_batch(double tie_bias) {
  Collider collider = implemented<float>(
      {.name = "batch",
       .version = {},
       .description = "clip, many pairs at once, one a lane of the widest vectors",
       .scalar = ScalarType::float32,
       .tie_bias = tie_bias},
      collide_as_batch<float>);
  collider.with_tie_bias = make_batch;
  return collider;
}

Collider make_batch64(double tie_bias) {
  Collider collider = implemented<double>({.name = "batch64",
                                           .version = {},
                                           .description = "clip64, many pairs at once, one a lane",
                                           .scalar = ScalarType::float64,
                                           .tie_bias = tie_bias},
                                          collide_as_batch<double>);
  collider.with_tie_bias = make_batch64;
  return collider;
}

}  // namespace manifuzz
