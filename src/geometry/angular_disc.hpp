#pragma once

#include <cmath>

#include "geometry/convex_polygon.hpp"

namespace manifuzz {

/// Bullet's measure of how far turning about its own origin moves a shape, a length: the circle
/// around its bounding box, radius included, and that one's distance from the origin.
template <class Scalar>
Scalar angular_disc(const ConvexPolygon<Scalar>& shape) {
  Vector2<Scalar> least = shape.vertices[0];
  Vector2<Scalar> greatest = shape.vertices[0];
  for (int i = 1; i < shape.count; ++i) {
    least = least.cwiseMin(shape.vertices[i]);
    greatest = greatest.cwiseMax(shape.vertices[i]);
  }
  const Vector2<Scalar> half = (greatest - least) / 2 + Vector2<Scalar>(shape.radius, shape.radius);
  const Vector2<Scalar> centre = (greatest + least) / 2;
  return std::sqrt(half.dot(half)) + std::sqrt(centre.dot(centre));
}

}  // namespace manifuzz
