// Bullet's btGjkPairDetector with btGjkEpaPenetrationDepthSolver, prism against prism.

#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>

#include "oracle/bullet/pair_detector.hpp"

#define MANIFUZZ_BULLET_SOLVER "btGjkEpaPenetrationDepthSolver"
#include "oracle/bullet/snippet.hpp"

extern "C" {

extern const manifuzz_declaration manifuzz_collider = manifuzz_bullet::declaration(
    "bullet-epa", MANIFUZZ_BULLET_VERSION, manifuzz_bullet::kSnippet,
    manifuzz_bullet::claims_of_point(1e-4, "btGjkEpa2.cpp: EPA_ACCURACY 0.0001"));

int manifuzz_collide(const manifuzz_body* a, const manifuzz_body* b, manifuzz_manifold* manifold) {
  btGjkEpaPenetrationDepthSolver solver;
  return manifuzz_bullet::collide_prisms(*a, *b, solver, *manifold);
}

}  // extern "C"
