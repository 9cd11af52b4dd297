// Bullet's btConvexConvexAlgorithm, prism against prism: the deepest point, and those of three
// queries with the smaller shape turned a little.

#include "oracle/bullet/perturbed.hpp"

namespace {

constexpr manifuzz_claims claims() {
  manifuzz_claims of_manifold =
      manifuzz_bullet::claims_of_point(1e-4, "btGjkEpa2.cpp: EPA_ACCURACY 0.0001");
  of_manifold.answers = MANIFUZZ_CLAIMS_MANIFOLD;
  of_manifold.second_point = MANIFUZZ_SECOND_POINT_BY_CLIP;
  of_manifold.one_point_enough = 1;  // what turns find is all that there is
  return of_manifold;
}

}  // namespace

extern "C" {

extern const manifuzz_declaration manifuzz_collider = {
    .interface = MANIFUZZ_INTERFACE,
    .name = "bullet-perturbed",
    .version = MANIFUZZ_BULLET_VERSION,
    .scalar = MANIFUZZ_FLOAT32,
    .rounds_in = MANIFUZZ_WORLD,
    .answers_in = MANIFUZZ_WORLD,
    .points = MANIFUZZ_ON_SURFACE_B,
    .normal = MANIFUZZ_B_TO_A,
    .tie_bias = 0,
    .vertices_max = MANIFUZZ_VERTICES_MAX,
    .takes_radius = 0,
    .snippet = nullptr,
    .claims = claims(),
};

int manifuzz_collide(const manifuzz_body* a, const manifuzz_body* b, manifuzz_manifold* manifold) {
  using namespace manifuzz_bullet;
  const HalfHeights heights = half_heights(*a, *b);
  btConvexHullShape hull_a = hull_of(*a, heights.a);
  btConvexHullShape hull_b = hull_of(*b, heights.b);
  const CollisionObjects objects(hull_a, place_of(*a), hull_b, place_of(*b));
  return flatten(perturbed_points(objects), *manifold);
}

}  // extern "C"
