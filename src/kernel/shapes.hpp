#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/convex_polygon.hpp"

namespace manifuzz::kernel {

/// A polygon's corners and normals as the kernels fetch them: 128 bytes of float, two cache lines.
/// What lies beyond the last corner repeats the first, which changes no result: of equals, the
/// first counts.
template <class Scalar>
struct alignas(64) ShapeRows {
  std::array<Scalar, std::size_t{2} * kMaxVertices> vertices{};  ///< x0 y0 x1 y1 ...
  std::array<Scalar, std::size_t{2} * kMaxVertices> normals{};
};

/// The polygons that a scene's bodies refer to by index. Each is laid out once, when it is added.
template <class Scalar>
class Shapes {
 public:
  Shapes() = default;
  explicit Shapes(std::span<const ConvexPolygon<Scalar>> polygons) {
    for (const ConvexPolygon<Scalar>& polygon : polygons) add(polygon);
  }

  /// The new shape's index.
  std::uint32_t add(const ConvexPolygon<Scalar>& polygon);

  std::size_t size() const { return rows_.size(); }
  const ShapeRows<Scalar>& rows(std::uint32_t shape) const { return rows_[shape]; }
  unsigned count(std::uint32_t shape) const { return counts_[shape]; }
  Scalar radius(std::uint32_t shape) const { return radii_[shape]; }

 private:
  std::vector<ShapeRows<Scalar>> rows_;
  std::vector<std::uint8_t> counts_;
  std::vector<Scalar> radii_;
};

}  // namespace manifuzz::kernel
