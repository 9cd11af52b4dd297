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

/// The length of a direction's part in the plane; 0 where most of it leaves the plane, which is no
/// answer to a question of it.
inline float in_plane(const btVector3& normal) {
  const float length = std::hypot(normal.x(), normal.y());
  return std::abs(normal.z()) > length ? 0 : length;
}

/// What one query of btGjkPairDetector says of two prisms: the part of its translation that is in
/// the plane.
inline int collide_prisms(const manifuzz_body& a, const manifuzz_body& b,
                          btConvexPenetrationDepthSolver& solver, manifuzz_manifold& manifold) {
  const HalfHeights heights = half_heights(a, b);
  const btConvexHullShape of_a = hull_of(a, heights.a);
  const btConvexHullShape of_b = hull_of(b, heights.b);
  const btPointCollector found = closest_points(of_a, place_of(a), of_b, place_of(b), solver);
  if (!found.m_hasResult || found.m_distance > 0) return 0;
  const btVector3& normal = found.m_normalOnBInWorld;
  const float length = in_plane(normal);
  if (length == 0) return 1;
  manifold.count = 1;
  manifold.normal = {normal.x() / length, normal.y() / length};
  manifold.points[0].position = {found.m_pointInWorld.x(), found.m_pointInWorld.y()};
  manifold.points[0].depth = std::max(-found.m_distance * length, 0.0F);
  return 0;
}

/// What one query claims: a point, no clip, and how far it stops short.
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

/// What a collider of this folder declares.
constexpr manifuzz_declaration declaration(const char* name, const char* version,
                                           const char* snippet, const manifuzz_claims& claims) {
  return {.interface = MANIFUZZ_INTERFACE,
          .name = name,
          .version = version,
          .scalar = MANIFUZZ_FLOAT32,
          .rounds_in = MANIFUZZ_WORLD,
          .answers_in = MANIFUZZ_WORLD,
          .points = MANIFUZZ_ON_SURFACE_B,
          .normal = MANIFUZZ_B_TO_A,
          .tie_bias = 0,
          .vertices_max = MANIFUZZ_VERTICES_MAX,
          .takes_radius = 0,
          .snippet = snippet,
          .claims = claims};
}

}  // namespace manifuzz_bullet
