#include "methods/closest_points.hpp"
#include "own_colliders/own_colliders.hpp"

namespace manifuzz {
namespace {

template <class Scalar>
Answer closest_points(const PairCase& pair, Scalar) {
  const auto placed = clipping::placed_pair<Scalar>(pair);
  const Pose<Scalar> b_in_a = relative_pose(placed.pose_a, placed.pose_b);
  methods::Simplex hint;
  Manifold<Scalar> manifold =
      methods::contact_by_gjk(placed.a, placed.b, b_in_a, hint).manifold;
  manifold.points[0].position *= placed.local_per_world;
  return manifold_cast<double>(manifold);
}

template <class Scalar>
Collider of_closest_points(std::string name, std::string description) {
  Collider collider =
      own::collider_of<Scalar>({.name = std::move(name),
                                .version = MANIFUZZ_VERSION,
                                .description = std::move(description),
                                .min_vertices = 1,
                                .takes_round = true,
                                .claims = Claims::point},
                               closest_points<Scalar>, nullptr);
  collider.in_double = make_gjk64;
  return collider;
}

}  // namespace

Collider make_gjk() {
  return of_closest_points<float>(
      "gjk", "closest points by GJK, and EPA where cores overlap, in float; one point");
}

Collider make_gjk64() {
  return of_closest_points<double>("gjk64", "the same in double, on the same float input");
}

}  // namespace manifuzz
