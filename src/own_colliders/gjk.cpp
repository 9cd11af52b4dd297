#include "methods/clip_by_gjk.hpp"
#include "methods/closest_points.hpp"
#include "own_colliders/own_colliders.hpp"

namespace manifuzz {
namespace {

/// What `contact` makes of the placed pair and of B's pose in A's frame, as an answer.
template <class Scalar, class Contact>
Answer answer_of(const PairCase& pair, const Contact& contact) {
  const auto placed = clipping::placed_pair<Scalar>(pair);
  Manifold<Scalar> manifold =
      contact(placed.a, placed.b, relative_pose(placed.pose_a, placed.pose_b));
  for (int i = 0; i < manifold.count; ++i) manifold.points[i].position *= placed.local_per_world;
  return manifold_cast<double>(manifold);
}

template <class Scalar>
Answer closest_points(const PairCase& pair, Scalar) {
  return answer_of<Scalar>(pair, [](const auto& a, const auto& b, const Pose<Scalar>& b_in_a) {
    methods::Simplex hint;
    return methods::contact_by_gjk(a, b, b_in_a, hint).manifold;
  });
}

Answer clipped(const PairCase& pair, float) {
  return answer_of<float>(pair, [](const auto& a, const auto& b, const Pose<float>& b_in_a) {
    methods::Simplex hint;
    return methods::clip_by_gjk(a, transform(b_in_a, b), hint);
  });
}

template <class Scalar>
Collider of_closest_points(std::string name, std::string description) {
  Collider collider = own::collider_of<Scalar>({.name = std::move(name),
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

Collider make_gjk_clip() {
  return own::collider_of<float>(
      {.name = "gjk-clip",
       .version = MANIFUZZ_VERSION,
       .description = "faces by GJK and EPA, points by clipping, in float"},
      clipped, nullptr);
}

}  // namespace manifuzz
