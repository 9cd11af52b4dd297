#include "kernel/shape_rows.hpp"

namespace manifuzz::kernel {

ShapeRows rows_of(const ConvexPolygon<float>& polygon) {
  ShapeRows rows;
  for (int i = 0; i < kMaxVertices; ++i) {
    const int corner = i < polygon.count ? i : 0;
    rows.x[i] = polygon.vertices[corner].x();
    rows.y[i] = polygon.vertices[corner].y();
    rows.normal_x[i] = polygon.normals[corner].x();
    rows.normal_y[i] = polygon.normals[corner].y();
  }
  rows.count = polygon.count;
  rows.radius = polygon.radius;
  return rows;
}

ConvexPolygon<float> polygon_of(const ShapeRows& rows) {
  ConvexPolygon<float> polygon;
  polygon.count = rows.count;
  polygon.radius = rows.radius;
  for (int i = 0; i < rows.count; ++i) {
    polygon.vertices[i] = {rows.x[i], rows.y[i]};
    polygon.normals[i] = {rows.normal_x[i], rows.normal_y[i]};
  }
  return polygon;
}

}  // namespace manifuzz::kernel
