#include "kernel/shapes.hpp"

namespace manifuzz::kernel {

namespace {

/// So that the next element needs no memory.
template <class Vector>
void make_room_for_one(Vector& vector) {
  if (vector.size() == vector.capacity()) vector.reserve(2 * vector.size() + 1);
}

}  // namespace

template <class Scalar>
std::uint32_t Shapes<Scalar>::add(const ConvexPolygon<Scalar>& polygon) {
  make_room_for_one(polygons_);
  make_room_for_one(corners_);
  make_room_for_one(kinds_);
  make_room_for_one(counts_);
  make_room_for_one(radii_);
  Scalar* scalar = corners_.emplace_back().scalars.data();
  for (int i = 0; i < kMaxVertices; ++i) {
    const int corner = i < polygon.count ? i : 0;
    for (const auto& of : {polygon.vertices[corner], polygon.normals[corner]}) {
      *scalar++ = of.x();
      *scalar++ = of.y();
    }
  }
  polygons_.push_back(polygon);
  const unsigned round = polygon.is_round() ? kPairGroups / 2 : 0;
  const auto corners = static_cast<unsigned>(polygon.count - 1);
  kinds_.push_back(static_cast<std::uint8_t>(round + corners * (kMaxVertices + 1)));
  counts_.push_back(static_cast<std::uint8_t>(polygon.count));
  radii_.push_back(polygon.radius);
  has_radius_ = has_radius_ || polygon.radius > 0;
  return static_cast<std::uint32_t>(corners_.size() - 1);
}

template class Shapes<float>;
template class Shapes<double>;

ShapeRows rows_of(const ConvexPolygon<float>& polygon) {
  ShapeRows rows;
  for (int i = 0; i < kMaxVertices; ++i) {
    const int at = i < polygon.count ? i : 0;
    rows.x[i] = polygon.vertices[at].x();
    rows.y[i] = polygon.vertices[at].y();
    rows.normal_x[i] = polygon.normals[at].x();
    rows.normal_y[i] = polygon.normals[at].y();
  }
  rows.count = polygon.count;
  rows.radius = polygon.radius;
  rows.rounding = polygon.rounding;
  return rows;
}

}  // namespace manifuzz::kernel
