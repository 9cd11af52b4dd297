#pragma once

#include <array>

#include "geometry/convex_polygon.hpp"

namespace manifuzz {

/// A convex polygon on the drawing board: counter-clockwise, in doubles, not yet rounded to floats.
/// Face i runs from vertex i to vertex i + 1.
struct Outline {
  std::array<Vector2<double>, kMaxVertices> vertices;
  int count = 0;

  int next(int i) const { return i + 1 < count ? i + 1 : 0; }
  int previous(int i) const { return i > 0 ? i - 1 : count - 1; }
  Vector2<double> face(int i) const { return vertices[next(i)] - vertices[i]; }
};

}  // namespace manifuzz
