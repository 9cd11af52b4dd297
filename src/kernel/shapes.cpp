#include "kernel/shapes.hpp"

namespace manifuzz::kernel {

namespace {

template <class Scalar>
unsigned kind_of(const ConvexPolygon<Scalar>& shape) {
  if (!shape.is_round()) return static_cast<unsigned>(shape.count - kMinVertices);
  return shape.count == 1 ? kCircle : kRoundCore;
}

}  // namespace

template <class Scalar>
std::uint32_t Shapes<Scalar>::add(const ConvexPolygon<Scalar>& shape) {
  Scalar* scalar = corners_.emplace_back().scalars.data();
  for (int i = 0; i < kMaxVertices; ++i) {
    const int corner = i < shape.count ? i : 0;
    for (const auto& of : {shape.vertices[corner], shape.normals[corner]}) {
      *scalar++ = of.x();
      *scalar++ = of.y();
    }
  }
  polygons_.push_back(shape);
  kinds_.push_back(static_cast<std::uint8_t>(kind_of(shape)));
  counts_.push_back(static_cast<std::uint8_t>(shape.count));
  radii_.push_back(shape.radius);
  has_radius_ = has_radius_ || shape.radius > 0;
  return static_cast<std::uint32_t>(corners_.size() - 1);
}

template class Shapes<float>;
template class Shapes<double>;

ShapeRows rows_of(const ConvexPolygon<float>& shape) {
  ShapeRows rows;
  for (int i = 0; i < kMaxVertices; ++i) {
    const int at = i < shape.count ? i : 0;
    rows.x[i] = shape.vertices[at].x();
    rows.y[i] = shape.vertices[at].y();
    rows.normal_x[i] = shape.normals[at].x();
    rows.normal_y[i] = shape.normals[at].y();
  }
  rows.count = shape.count;
  rows.radius = shape.radius;
  rows.rounding = shape.rounding;
  return rows;
}

ConvexPolygon<float> polygon_of(const ShapeRows& rows) {
  ConvexPolygon<float> polygon;
  polygon.count = rows.count;
  polygon.radius = rows.radius;
  polygon.rounding = rows.rounding;
  for (int i = 0; i < rows.count; ++i) {
    polygon.vertices[i] = {rows.x[i], rows.y[i]};
    polygon.normals[i] = {rows.normal_x[i], rows.normal_y[i]};
  }
  return polygon;
}

}  // namespace manifuzz::kernel
