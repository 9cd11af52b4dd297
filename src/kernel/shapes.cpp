#include "kernel/shapes.hpp"

namespace manifuzz::kernel {

template <class Scalar>
std::uint32_t Shapes<Scalar>::add(const ConvexPolygon<Scalar>& polygon) {
  ShapeRows<Scalar>& rows = rows_.emplace_back();
  for (int i = 0; i < kMaxVertices; ++i) {
    const int corner = i < polygon.count ? i : 0;
    for (int axis = 0; axis < 2; ++axis) {
      rows.vertices[2 * i + axis] = polygon.vertices[corner][axis];
      rows.normals[2 * i + axis] = polygon.normals[corner][axis];
    }
  }
  counts_.push_back(static_cast<std::uint8_t>(polygon.count));
  radii_.push_back(polygon.radius);
  return static_cast<std::uint32_t>(rows_.size() - 1);
}

template class Shapes<float>;
template class Shapes<double>;

}  // namespace manifuzz::kernel
