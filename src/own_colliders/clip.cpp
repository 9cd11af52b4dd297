#include "clipping/collide.hpp"
#include "own_colliders/own_colliders.hpp"

namespace manifuzz {
namespace {

/// What `collide` makes of the placed pair and of B's pose in A's frame, as an answer.
template <class Scalar, class Collide>
Answer answer(const PairCase& pair, const Collide& collide) {
  const auto placed = clipping::placed_where_it_is<Scalar>(pair);
  const Pose<Scalar> b_in_a = relative_pose(placed.pose_a, placed.pose_b);
  Manifold<Scalar> manifold = collide(placed, b_in_a);
  for (int i = 0; i < manifold.count; ++i) manifold.points[i].position *= placed.local_per_world;
  return manifold_cast<double>(manifold);
}

template <class Scalar>
Answer collide(const PairCase& pair, Scalar tie_bias) {
  return answer<Scalar>(pair, [tie_bias](const auto& placed, const Pose<Scalar>& b_in_a) {
    return clipping::collide(placed.a, placed.b, b_in_a, tie_bias);
  });
}

template <class Scalar>
Collider implemented(const Declaration& declaration, Collider (*with_tie_bias)(double tie_bias)) {
  Collider collider = own::collider_of<Scalar>(declaration, collide<Scalar>, with_tie_bias);
  collider.from_normal = [](const PairCase& pair, const Vector2<double>& normal) {
    return answer<Scalar>(pair, [&](const auto& placed, const Pose<Scalar>& b_in_a) {
      return clipping::manifold_from_normal<Scalar>(placed.a, placed.b, b_in_a,
                                                    normal.cast<Scalar>());
    });
  };
  return collider;
}

}  // namespace

Collider make_clip(double tie_bias) {
  return implemented<float>(
      {.name = "clip",
       .version = MANIFUZZ_VERSION,
       .description =
           "the article's clipping in float, incident edge by least dot, no empty overlap",
       .tie_bias = {tie_bias},
       .min_vertices = 1,
       .takes_round = true},
      make_clip);
}

Collider make_clip64(double tie_bias) {
  return implemented<double>(
      {.name = "clip64",
       .version = MANIFUZZ_VERSION,
       .description = "the article's clipping in double, on the same float input",
       .tie_bias = {tie_bias},
       .min_vertices = 1,
       .takes_round = true},
      make_clip64);
}

}  // namespace manifuzz
