#pragma once

#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "manifuzz_collider.h"

// Bullet has no shapes of the plane that its EPA can tell the depth of: a polygon is a prism along
// z, higher than any depth, so that the least depth is in the plane.

namespace manifuzz_bullet {

/// How far a body reaches from its origin.
inline float reach(const manifuzz_body& body) {
  float farthest = 0;
  for (int i = 0; i < body.count; ++i) {
    farthest = std::max(farthest, std::hypot(body.vertices[i].x, body.vertices[i].y));
  }
  return farthest + body.radius;
}

/// How far prisms go up and down: along z they overlap by more than both reaches, and in the plane,
/// across the line between their origins, by no more. They differ, since in a difference that is
/// flat at the origin EPA takes the plane for the nearest face.
struct HalfHeights {
  float a = 0;
  float b = 0;
};

inline HalfHeights half_heights(const manifuzz_body& a, const manifuzz_body& b) {
  const float both = reach(a) + reach(b);
  return {0.7F * both, 0.5F * both};
}

/// A prism of this half height, or flat where that is 0. The radius of round shapes is a margin;
/// circles are upright segments with one, and segments upright rectangles.
inline btConvexHullShape hull_of(const manifuzz_body& body, float half_height) {
  std::array<btVector3, 2 * MANIFUZZ_VERTICES_MAX> corners;
  int count = 0;
  for (int i = 0; i < body.count; ++i) {
    const auto [x, y] = body.vertices[i];
    corners[count++].setValue(x, y, half_height);
    if (half_height > 0) corners[count++].setValue(x, y, -half_height);
  }
  btConvexHullShape hull(corners[0], count);
  hull.setMargin(body.radius);
  return hull;
}

inline btTransform place_of(const manifuzz_body& body) {
  const auto [cos, sin] = body.rotation;
  return btTransform(btMatrix3x3(cos, -sin, 0, sin, cos, 0, 0, 0, 1),
                     btVector3(body.position.x, body.position.y, 0));
}

}  // namespace manifuzz_bullet
