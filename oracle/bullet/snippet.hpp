#pragma once

namespace manifuzz_bullet {

/// The program of reports on Bullet's btGjkPairDetector, whose MANIFUZZ_BULLET_SOLVER, a string,
/// says how deep shapes overlap; report/upstream fills it in.
inline constexpr const char* kSnippet = R"(@language cpp
@point m_pointInWorld $b, m_distance $s
#include <BulletCollision/CollisionDispatch/btConvexConvexAlgorithm.h>
#include <BulletCollision/NarrowPhaseCollision/)" MANIFUZZ_BULLET_SOLVER R"(.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <btBulletCollisionCommon.h>
#include <cstdio>
int main() {  // of prisms along z, so high that the least depth is in the plane
  btConvexHullShape a, b;
  for (btVector3 v : {@a.vertices(btVector3($x, $y, 0))@}) for (float z : {0.7F, -0.7F}) a.addPoint(v + btVector3(0, 0, z * (float(@a.reach@) + float(@b.reach@))));
  for (btVector3 v : {@b.vertices(btVector3($x, $y, 0))@}) for (float z : {0.5F, -0.5F}) b.addPoint(v + btVector3(0, 0, z * (float(@a.reach@) + float(@b.reach@))));
  a.setMargin(@a.radius@), b.setMargin(@b.radius@); btGjkPairDetector::ClosestPointInput input;
@each   input.m_transform@^ = btTransform(btMatrix3x3(@*.rotation($x, -float($y), 0, $y, $x, 0, 0, 0, 1)@), btVector3(@*.position($x, $y, 0)@));
  btVoronoiSimplexSolver simplex; )" MANIFUZZ_BULLET_SOLVER R"( solver; btPointCollector found;
  btGjkPairDetector(&a, &b, &simplex, &solver).@asked(getClosestPoints)@(input, found, nullptr);
  const btVector3 n = found.m_normalOnBInWorld; const float part = std::hypot(n.x(), n.y());  // of it in the plane
  std::printf("%d points, normal (%.9g, %.9g)\n", found.m_hasResult && found.m_distance <= 0, n.x() / part, n.y() / part);
  std::printf("(%.9g, %.9g), distance %.9g\n", found.m_pointInWorld.x(), found.m_pointInWorld.y(), found.m_distance * part);
}
)";

}  // namespace manifuzz_bullet
