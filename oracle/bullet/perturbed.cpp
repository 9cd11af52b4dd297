// Bullet's btConvexConvexAlgorithm, prism against prism: the deepest point, and those of three
// queries with the smaller shape turned a little.

#include "oracle/bullet/perturbed.hpp"

#define MANIFUZZ_BULLET_HEADERS                                              \
  "#include <BulletCollision/CollisionDispatch/btConvexConvexAlgorithm.h>\n" \
  "#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>\n"
#define MANIFUZZ_BULLET_SHAPES                                                                     \
  "  // prisms along z, so high that the least depth is in the plane\n"                            \
  "  btConvexHullShape a; for (btVector3 v : {@a.vertices(btVector3($x, $y, 0))@}) for (float z "  \
  ": {0.7F, -0.7F}) a.addPoint(v + btVector3(0, 0, z * (float(@a.reach@) + float(@b.reach@))));\n" \
  "  btConvexHullShape b; for (btVector3 v : {@b.vertices(btVector3($x, $y, 0))@}) for (float z "  \
  ": {0.5F, -0.5F}) b.addPoint(v + btVector3(0, 0, z * (float(@a.reach@) + float(@b.reach@))));\n" \
  "  a.setMargin(@a.radius@), b.setMargin(@b.radius@);\n"
#define MANIFUZZ_BULLET_ALGORITHM                                                        \
  "  btGjkEpaPenetrationDepthSolver solver; btConvexConvexAlgorithm algorithm(nullptr, " \
  "btCollisionAlgorithmConstructionInfo(&dispatcher, -1), &inA, &inB, &solver, 3, 4);\n"
#include "oracle/bullet/algorithm_snippet.hpp"

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

extern const manifuzz_declaration manifuzz_collider = manifuzz_bullet::declaration(
    "bullet-perturbed", MANIFUZZ_BULLET_VERSION, manifuzz_bullet::kAlgorithmSnippet, claims());

int manifuzz_collide(const manifuzz_body* a, const manifuzz_body* b, manifuzz_manifold* manifold) {
  using namespace manifuzz_bullet;
  const HalfHeights heights = half_heights(*a, *b);
  btConvexHullShape hull_a = hull_of(*a, heights.a);
  btConvexHullShape hull_b = hull_of(*b, heights.b);
  const CollisionObjects objects(hull_a, place_of(*a), hull_b, place_of(*b));
  return flatten(perturbed_points(objects), *manifold);
}

}  // extern "C"
