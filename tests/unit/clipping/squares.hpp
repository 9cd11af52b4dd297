#pragma once

#include <vector>

#include "geometry/convex_polygon.hpp"

namespace manifuzz::test {

inline ConvexPolygon<float> polygon(const std::vector<Vector2<float>>& vertices, float radius = 0) {
  return make_polygon<float>(vertices, radius);
}

/// A square of half width 1, around the origin.
inline ConvexPolygon<float> square(float radius = 0) {
  return polygon({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, radius);
}

}  // namespace manifuzz::test
