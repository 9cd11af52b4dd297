// Bullet's btGjkPairDetector with btMinkowskiPenetrationDepthSolver, prism against prism.

#include <BulletCollision/NarrowPhaseCollision/btMinkowskiPenetrationDepthSolver.h>

#include "oracle/bullet/pair_detector.hpp"

#define MANIFUZZ_BULLET_SOLVER "btMinkowskiPenetrationDepthSolver"
#include "oracle/bullet/snippet.hpp"

extern "C" {

extern const manifuzz_declaration manifuzz_collider = manifuzz_bullet::declaration(
    "bullet-minkowski", MANIFUZZ_BULLET_VERSION, manifuzz_bullet::kSnippet,
    manifuzz_bullet::claims_of_point(0, nullptr));

int manifuzz_collide(const manifuzz_body* a, const manifuzz_body* b, manifuzz_manifold* manifold) {
  btMinkowskiPenetrationDepthSolver solver;
  return manifuzz_bullet::collide_prisms(*a, *b, solver, *manifold);
}

}  // extern "C"
