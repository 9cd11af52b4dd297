#pragma once

#include <box2d/b2_math.h>
#include <box2d/b2_polygon_shape.h>

#include "geometry/convex_polygon.hpp"

// The stored floats as Box2D's own types, converted without rounding.

namespace manifuzz::box2d {

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
  for (int i = 0; i < polygon.count; ++i) {
    shape.m_vertices[i] = to_box2d(polygon.vertices[i]);
    shape.m_normals[i] = to_box2d(polygon.normals[i]);
  }
  shape.m_count = polygon.count;
  shape.m_radius = polygon.radius;
  return shape;
}

}  // namespace manifuzz::box2d
