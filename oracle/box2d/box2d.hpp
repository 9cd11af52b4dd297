#pragma once

#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <vector>

#include <box2d/b2_math.h>
#include <box2d/b2_polygon_shape.h>

#include "engines/engine.hpp"
#include "geometry/convex_polygon.hpp"
#include "geometry/pair_case.hpp"

namespace manifuzz::box2d {

// The stored floats as Box2D's own types, converted without rounding.

inline b2Vec2 to_box2d(const Vector2<float>& v) {
  return {v.x(), v.y()};
}

inline b2Transform to_box2d(const Pose<float>& pose) {
  b2Transform transform;
  transform.p = to_box2d(pose.position);
  transform.q.c = pose.rotation.x();
  transform.q.s = pose.rotation.y();
  return transform;
}

/// Filled as it stands: `b2PolygonShape::Set` would weld, reorder and assert.
inline b2PolygonShape to_box2d(const ConvexPolygon<float>& polygon) {
  b2PolygonShape shape;
  static_assert(sizeof(shape.m_vertices) == sizeof(polygon.vertices) &&
                sizeof(shape.m_normals) == sizeof(polygon.normals));
  std::memcpy(&shape.m_vertices[0].x, polygon.vertices[0].data(), sizeof(shape.m_vertices));
  std::memcpy(&shape.m_normals[0].x, polygon.normals[0].data(), sizeof(shape.m_normals));
  shape.m_count = polygon.count;
  shape.m_radius = polygon.radius;
  return shape;
}

}  // namespace manifuzz::box2d

namespace manifuzz {

/// The manifolds of a scene as Box2D's contact manager gets them (b2_contact_manager.cpp), without
/// its solver: `b2BroadPhase` with its fattened boxes, and `b2CollidePolygons` on every pair that
/// it reports.
std::unique_ptr<ScenePairs> box2d_pairs(std::span<const Body> bodies);

/// The poses of all bodies after each step of `b2World::Step` (b2_world.cpp): 1/60 s, 8 and 3
/// iterations, gravity 10, downwards until it turns, density
/// 1, friction 0.5, sleep allowed. Lengths are metres; polygons are taken as they stand, skins and
/// all.
std::vector<std::vector<Pose<float>>> box2d_trajectory(std::span<const WorldBody> bodies, int steps,
                                                       const GravityTurn& gravity_turn);

/// Box2D's `b2CollidePolygons` (b2_collide_polygon.cpp), on shapes filled from the stored floats:
/// `b2PolygonShape::Set` would weld, reorder and assert. Its answer is converted without rounding
/// that counts: points from the incident body's frame in double, depths from `b2WorldManifold`.
Collider make_box2d();

/// `b2CollidePolygons` alone, or of round pairs the functions of their shapes, through all pairs
/// once, on shapes and transforms laid out beforehand.
std::function<void()> box2d_pass(std::span<const PairCase> pairs);

}  // namespace manifuzz
