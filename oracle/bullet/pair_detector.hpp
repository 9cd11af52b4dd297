#pragma once

#include <BulletCollision/CollisionShapes/btConvexShape.h>
#include <BulletCollision/NarrowPhaseCollision/btConvexPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
#include <cmath>

#include "oracle/bullet/prism.hpp"

namespace manifuzz_bullet {

/// The closest points of both, or their deepest as `solver` has it.
inline btPointCollector closest_points(const btConvexShape& a, const btTransform& place_a,
                                       const btConvexShape& b, const btTransform& place_b,
                                       btConvexPenetrationDepthSolver& solver) {
  btVoronoiSimplexSolver simplex;
  btGjkPairDetector detector(&a, &b, &simplex, &solver);
  btGjkPairDetector::ClosestPointInput input;
  input.m_transformA = place_a;
  input.m_transformB = place_b;
  btPointCollector found;
  detector.getClosestPoints(input, found, nullptr);
  return found;
}

/// Whether a direction leaves the plane: no answer to a question of it.
inline bool leaves_plane(const btVector3& normal) {
  return std::abs(normal.z()) > std::hypot(normal.x(), normal.y());
}

/// What one query of btGjkPairDetector says of two prisms.
inline int collide_prisms(const manifuzz_body& a, const manifuzz_body& b,
                          btConvexPenetrationDepthSolver& solver, manifuzz_manifold& manifold) {
  const float height = half_height(a, b);
  const btConvexHullShape of_a = hull_of(a, height);
  const btConvexHullShape of_b = hull_of(b, height);
  const btPointCollector found = closest_points(of_a, place_of(a), of_b, place_of(b), solver);
  if (!found.m_hasResult || found.m_distance > 0) return 0;
  const btVector3& normal = found.m_normalOnBInWorld;
  if (leaves_plane(normal)) return 1;
  manifold.count = 1;
  manifold.normal = {normal.x(), normal.y()};
  manifold.points[0].position = {found.m_pointInWorld.x(), found.m_pointInWorld.y()};
  manifold.points[0].depth = std::max(-found.m_distance, 0.0F);
  return 0;
}

/// What one query claims: a point on B, a normal from B to A, and how far it stops short.
constexpr manifuzz_claims claims_of_point(double tolerance, const char* source) {
  manifuzz_claims claims{};
  claims.answers = MANIFUZZ_CLAIMS_POINT;
  claims.does_not_clip = 1;
  claims.tolerance_absolute = tolerance;
  claims.tolerance_source = source;
  claims.vertices_min = 1;
  claims.takes_round = 1;
  claims.second_point = MANIFUZZ_SECOND_POINT_NEVER;
  return claims;
}

}  // namespace manifuzz_bullet
