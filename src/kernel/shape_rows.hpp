#pragma once

#include "geometry/convex_polygon.hpp"

namespace manifuzz::kernel {

/// A polygon as one pair at a time takes it: a row for each coordinate, so that a vector holds a
/// coordinate of every face. The places past the last corner repeat the first, which changes no
/// result: of equals, the first counts.
struct alignas(64) ShapeRows {
  float x[kMaxVertices];         ///< of each vertex
  float y[kMaxVertices];         ///< of each vertex
  float normal_x[kMaxVertices];  ///< of each face
  float normal_y[kMaxVertices];  ///< of each face
  int count = 0;                 ///< of vertices
  float radius = 0;              ///< a length, >= 0
};

/// A polygon, laid out in the same frame.
ShapeRows rows_of(const ConvexPolygon<float>& polygon);

/// The polygon that was laid out.
ConvexPolygon<float> polygon_of(const ShapeRows& rows);

}  // namespace manifuzz::kernel
