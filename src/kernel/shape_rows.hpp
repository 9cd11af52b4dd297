#pragma once

#include "geometry/convex_polygon.hpp"

namespace manifuzz::kernel {

/// A polygon as one pair at a time takes it: a row for each coordinate, so that a vector holds a
/// coordinate of every face. The places past the last corner repeat the first, which changes no
/// result: of equals, the first counts.
struct alignas(64) ShapeRows {
  float x[kMaxVertices];
  float y[kMaxVertices];
  float normal_x[kMaxVertices];
  float normal_y[kMaxVertices];
  int count = 0;
  float radius = 0;
};

ShapeRows rows_of(const ConvexPolygon<float>& polygon);

ConvexPolygon<float> polygon_of(const ShapeRows& rows);

}  // namespace manifuzz::kernel
