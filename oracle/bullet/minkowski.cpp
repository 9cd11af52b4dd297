// Bullet's btGjkPairDetector with btMinkowskiPenetrationDepthSolver, prism against prism.

#include <BulletCollision/NarrowPhaseCollision/btMinkowskiPenetrationDepthSolver.h>

#include "oracle/bullet/pair_detector.hpp"

#define MANIFUZZ_BULLET_SOLVER "btMinkowskiPenetrationDepthSolver"
#include "oracle/bullet/snippet.hpp"

extern "C" {

extern const manifuzz_declaration manifuzz_collider = {
    .interface = MANIFUZZ_INTERFACE,
    .name = "bullet-minkowski",
    .version = MANIFUZZ_BULLET_VERSION,
    .scalar = MANIFUZZ_FLOAT32,
    .rounds_in = MANIFUZZ_WORLD,
    .answers_in = MANIFUZZ_WORLD,
    .points = MANIFUZZ_ON_SURFACE_B,
    .normal = MANIFUZZ_B_TO_A,
    .tie_bias = 0,
    .vertices_max = MANIFUZZ_VERTICES_MAX,
    .takes_radius = 0,
    .snippet = manifuzz_bullet::kSnippet,
    .claims = manifuzz_bullet::claims_of_point(0, nullptr),
};

int manifuzz_collide(const manifuzz_body* a, const manifuzz_body* b, manifuzz_manifold* manifold) {
  btMinkowskiPenetrationDepthSolver solver;
  return manifuzz_bullet::collide_prisms(*a, *b, solver, *manifold);
}

}  // extern "C"
