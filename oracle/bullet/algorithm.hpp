#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <algorithm>
#include <vector>

#include "oracle/bullet/pair_detector.hpp"

// Bullet's collision algorithms, asked once as its dispatcher asks them: with a new manifold, of
// the breaking threshold that both shapes give it.

namespace manifuzz_bullet {

/// Two bodies as a world of Bullet's has them. The shapes must outlive them.
struct CollisionObjects {
  CollisionObjects(btCollisionShape& shape_a, const btTransform& place_a, btCollisionShape& shape_b,
                   const btTransform& place_b) {
    a.setCollisionShape(&shape_a);
    b.setCollisionShape(&shape_b);
    a.setWorldTransform(place_a);
    b.setWorldTransform(place_b);
  }

  btCollisionObject a;
  btCollisionObject b;
};

/// The points that an algorithm leaves in its manifold.
template <class MakeAlgorithm>
std::vector<btManifoldPoint> points_of(const CollisionObjects& objects,
                                       const MakeAlgorithm& make_algorithm) {
  static btDefaultCollisionConfiguration configuration;
  static btCollisionDispatcher dispatcher(&configuration);
  const auto wrapped = [](const btCollisionObject& object) {
    return btCollisionObjectWrapper(nullptr, object.getCollisionShape(), &object,
                                    object.getWorldTransform(), -1, -1);
  };
  const btCollisionObjectWrapper wrapped_a = wrapped(objects.a);
  const btCollisionObjectWrapper wrapped_b = wrapped(objects.b);
  const btCollisionAlgorithmConstructionInfo info(&dispatcher, -1);
  auto algorithm = make_algorithm(info, wrapped_a, wrapped_b);
  btManifoldResult result(&wrapped_a, &wrapped_b);
  algorithm.processCollision(&wrapped_a, &wrapped_b, btDispatcherInfo(), &result);
  std::vector<btManifoldPoint> points;
  const btPersistentManifold& manifold = *result.getPersistentManifold();
  for (int i = 0; i < manifold.getNumContacts(); ++i) {
    points.push_back(manifold.getContactPoint(i));
  }
  return points;
}

/// The points that touch, seen in the plane: the deepest, with its normal, and of the others the
/// one that is farthest from it. Returns what manifuzz_collide does.
inline int flatten(std::vector<btManifoldPoint> points, manifuzz_manifold& manifold) {
  std::erase_if(points, [](const btManifoldPoint& point) { return point.getDistance() > 0; });
  if (points.empty()) return 0;
  const btManifoldPoint& deepest =
      *std::ranges::min_element(points, {}, &btManifoldPoint::getDistance);
  const btVector3& normal = deepest.m_normalWorldOnB;
  const float length = in_plane(normal);
  if (length == 0) return 1;
  const auto apart = [&](const btManifoldPoint& point) {
    const btVector3 from = point.getPositionWorldOnB() - deepest.getPositionWorldOnB();
    return std::hypot(from.x(), from.y());
  };
  const btManifoldPoint& farthest = *std::ranges::max_element(points, {}, apart);
  manifold.normal = {normal.x() / length, normal.y() / length};
  for (const btManifoldPoint* const point : {&deepest, &farthest}) {
    if (manifold.count > 0 && apart(*point) == 0) break;
    const btVector3& place = point->getPositionWorldOnB();
    manifold.points[manifold.count++] = {.position = {place.x(), place.y()},
                                         .depth = std::max(-point->getDistance() * length, 0.0F),
                                         .feature_a = {},
                                         .feature_b = {}};
  }
  return 0;
}

}  // namespace manifuzz_bullet
