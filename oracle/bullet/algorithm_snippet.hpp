#pragma once

namespace manifuzz_bullet {

/// The program of reports on Bullet's collision algorithms: MANIFUZZ_BULLET_HEADERS,
/// MANIFUZZ_BULLET_SHAPES and MANIFUZZ_BULLET_ALGORITHM, strings, are what one of them needs;
/// report/upstream fills it in.
inline constexpr const char* kAlgorithmSnippet =
    R"(@language cpp
@none no point of a getDistance() of 0 or less
@point getPositionWorldOnB() $b, getDistance() $s
)" MANIFUZZ_BULLET_HEADERS R"(#include <btBulletCollisionCommon.h>
#include <cstdio>
int main() {
)" MANIFUZZ_BULLET_SHAPES
    R"(@each   btCollisionObject object@^; object@^.setCollisionShape(&@*); object@^.setWorldTransform(btTransform(btMatrix3x3(@*.rotation($x, -float($y), 0, $y, $x, 0, 0, 0, 1)@), btVector3(@*.position($x, $y, 0)@))); btCollisionObjectWrapper in@^(nullptr, &@*, &object@^, object@^.getWorldTransform(), -1, -1);
  btDefaultCollisionConfiguration configuration; btCollisionDispatcher dispatcher(&configuration);
)" MANIFUZZ_BULLET_ALGORITHM
    R"(  btManifoldResult result(&inA, &inB); algorithm.@asked(processCollision)@(&inA, &inB, btDispatcherInfo(), &result);
  const btPersistentManifold& found = *result.getPersistentManifold(); std::printf("%d points\n", found.getNumContacts()); btManifoldPoint deepest; for (int i = 0; i < found.getNumContacts(); ++i) if (i == 0 || found.getContactPoint(i).getDistance() < deepest.getDistance()) deepest = found.getContactPoint(i);
  const btVector3 n = deepest.m_normalWorldOnB; const float part = std::hypot(n.x(), n.y());  /* of it in the plane */ for (int i = 0; i < found.getNumContacts(); ++i) for (const btManifoldPoint& p : {found.getContactPoint(i)}) std::printf("(%.9g, %.9g, %.9g), normal of the deepest (%.9g, %.9g), distance %.9g\n", p.getPositionWorldOnB().x(), p.getPositionWorldOnB().y(), p.getPositionWorldOnB().z(), n.x() / part, n.y() / part, p.getDistance() * part);
}
)";

}  // namespace manifuzz_bullet
