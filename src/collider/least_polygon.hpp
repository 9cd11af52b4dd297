#pragma once

#include <cmath>

#include "geometry/convex_polygon.hpp"

namespace manifuzz {

/// What a polygon must have at least to be given to a collider, by the engine's own check.
/// (Rapier's `convexPolyline` makes none where fewer than three corners turn by 0.026, Nape none of
/// an area below 1e-8.)
struct LeastPolygon {
  double turn = 0;  ///< an angle in radians, up to pi / 2: three of its corners turn by more
  double area = 0;  ///< in square world lengths: it has as much

  bool is_none() const { return turn == 0 && area == 0; }
};

/// Whether a polygon of 3 or more vertices has that; up to the roundings of a double.
inline bool has_at_least(const ConvexPolygon<float>& polygon, const LeastPolygon& least) {
  const double slope = std::tan(least.turn);
  int corners = 0;
  double twice_area = 0;
  const auto vertex = [&](int i) -> Vector2<double> {
    return polygon.vertices[static_cast<std::size_t>(i % polygon.count)].cast<double>();
  };
  for (int i = 0; i < polygon.count; ++i) {
    const Vector2<double> in = vertex(i + 1) - vertex(i);
    const Vector2<double> out = vertex(i + 2) - vertex(i + 1);
    const double along = in.dot(out);
    corners += along <= 0 || cross(in, out) > slope * along ? 1 : 0;
    twice_area += cross(Vector2<double>(vertex(i) - vertex(0)), in);
  }
  return corners >= kMinVertices && twice_area >= 2 * least.area;
}

}  // namespace manifuzz
