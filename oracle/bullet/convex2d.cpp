// Bullet's btConvex2dConvex2dAlgorithm with btMinkowskiPenetrationDepthSolver, as its example
// Planar2D has it: flat hulls as btConvex2dShape.

#include <BulletCollision/CollisionDispatch/btConvex2dConvex2dAlgorithm.h>
#include <BulletCollision/CollisionShapes/btConvex2dShape.h>
#include <BulletCollision/NarrowPhaseCollision/btMinkowskiPenetrationDepthSolver.h>

#include "oracle/bullet/algorithm.hpp"

#define MANIFUZZ_BULLET_HEADERS                                                  \
  "#include <BulletCollision/CollisionDispatch/btConvex2dConvex2dAlgorithm.h>\n" \
  "#include <BulletCollision/CollisionShapes/btConvex2dShape.h>\n"               \
  "#include <BulletCollision/NarrowPhaseCollision/btMinkowskiPenetrationDepthSolver.h>\n"
#define MANIFUZZ_BULLET_SHAPES                                                          \
  "@each   btVector3 of@^[] = {@*.vertices(btVector3($x, $y, 0))@}; btConvexHullShape " \
  "hull@^(*of@^, @*.count@);\n"                                                         \
  "@each   hull@^.setMargin(@*.radius@); btConvex2dShape @*(&hull@^);\n"
#define MANIFUZZ_BULLET_ALGORITHM                                                \
  "  btVoronoiSimplexSolver simplex; btMinkowskiPenetrationDepthSolver solver; " \
  "btConvex2dConvex2dAlgorithm algorithm(nullptr, "                              \
  "btCollisionAlgorithmConstructionInfo(&dispatcher, -1), &inA, &inB, &simplex, &solver, 0, 0);\n"
#include "oracle/bullet/algorithm_snippet.hpp"

extern "C" {

extern const manifuzz_declaration manifuzz_collider = manifuzz_bullet::declaration(
    "bullet-convex2d", MANIFUZZ_BULLET_VERSION, manifuzz_bullet::kAlgorithmSnippet,
    manifuzz_bullet::claims_of_point(0, nullptr));

int manifuzz_collide(const manifuzz_body* a, const manifuzz_body* b, manifuzz_manifold* manifold) {
  using namespace manifuzz_bullet;
  btConvexHullShape hull_a = hull_of(*a, 0);
  btConvexHullShape hull_b = hull_of(*b, 0);
  btConvex2dShape flat_a(&hull_a);
  btConvex2dShape flat_b(&hull_b);
  btVoronoiSimplexSolver simplex;
  btMinkowskiPenetrationDepthSolver solver;
  const CollisionObjects objects(flat_a, place_of(*a), flat_b, place_of(*b));
  return flatten(points_of(objects,
                           [&](const auto& info, const auto& of_a, const auto& of_b) {
                             return btConvex2dConvex2dAlgorithm(nullptr, info, &of_a, &of_b,
                                                                &simplex, &solver, 0, 0);
                           }),
                 *manifold);
}

}  // extern "C"
