#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/convex_polygon.hpp"

namespace manifuzz::kernel {

/// What the kernels fetch of a corner: vertex x, y; x, y of the normal of the face that begins
/// there.
inline constexpr int kCornerScalars = 4;

/// A polygon as the kernels fetch it: corner by corner, so that one of up to four corners is a
/// single cache line of floats. What lies beyond the last corner repeats the first, which changes
/// no result: of equals, the first counts.
template <class Scalar>
struct alignas(64) ShapeCorners {
  std::array<Scalar, std::size_t{kCornerScalars} * kMaxVertices> scalars{};  ///< corner by corner
};

/// The polygons that a scene's bodies refer to by index. Each is laid out once, when it is added.
template <class Scalar>
class Shapes {
 public:
  /// The new shape's index: 0, 1, 2, ...; none of a round shape, which kernels do not take. The
  /// polygon must be free of defects.
  std::optional<std::uint32_t> add(const ConvexPolygon<Scalar>& polygon);

  /// A shape, as the kernels fetch it, in its own frame.
  const ShapeCorners<Scalar>& corners(std::uint32_t shape) const { return corners_[shape]; }
  /// How many vertices a shape has.
  unsigned count(std::uint32_t shape) const { return counts_[shape]; }
  /// A shape's radius, a length.
  Scalar radius(std::uint32_t shape) const { return radii_[shape]; }
  bool has_radius() const { return has_radius_; }  ///< of any shape: it is not 0

 private:
  std::vector<ShapeCorners<Scalar>> corners_;
  std::vector<std::uint8_t> counts_;
  std::vector<Scalar> radii_;
  bool has_radius_ = false;
};

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

/// A polygon, laid out in the same frame; nothing of a round shape, which kernels do not take.
std::optional<ShapeRows> rows_of(const ConvexPolygon<float>& polygon);

/// The polygon that was laid out.
ConvexPolygon<float> polygon_of(const ShapeRows& rows);

}  // namespace manifuzz::kernel
