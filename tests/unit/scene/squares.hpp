#pragma once

#include <limits>

#include "geometry/convex_polygon.hpp"

namespace manifuzz::test {

inline constexpr float kInfinity = std::numeric_limits<float>::infinity();

inline ConvexPolygon<float> square(float half, float radius = 0) {
  const Vector2<float> corners[] = {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
  return make_polygon<float>(corners, radius);
}

}  // namespace manifuzz::test
