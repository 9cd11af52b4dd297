#pragma once

#include <cstdint>
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

/// Shapes that go through the kernels together: sharp polygons by their number of vertices, from 0
/// for kMinVertices on; then circles, and whatever else is round.
enum ShapeKind : unsigned {
  kCircle = kMaxVertices - kMinVertices + 1,  ///< one vertex and a radius
  kRoundCore,  ///< a segment, a capsule, or a polygon whose corners are round
  kShapeKinds  ///< how many kinds there are
};

/// The shapes that a scene's bodies refer to by index. Each is laid out once, when it is added.
template <class Scalar>
class Shapes {
 public:
  /// The new shape's index: 0, 1, 2, ... The shape must be free of defects. Where memory runs out,
  /// std::bad_alloc is thrown, and nothing has changed.
  std::uint32_t add(const ConvexPolygon<Scalar>& polygon);

  /// A shape, as the kernels fetch it, in its own frame.
  const ShapeCorners<Scalar>& corners(std::uint32_t shape) const { return corners_[shape]; }
  /// A shape as it was added.
  const ConvexPolygon<Scalar>& polygon(std::uint32_t shape) const { return polygons_[shape]; }
  /// A shape's `ShapeKind`.
  unsigned kind(std::uint32_t shape) const { return kinds_[shape]; }
  /// How many vertices a shape has.
  unsigned count(std::uint32_t shape) const { return counts_[shape]; }
  /// A shape's radius, a length.
  Scalar radius(std::uint32_t shape) const { return radii_[shape]; }
  bool has_radius() const { return has_radius_; }  ///< of any shape: it is not 0

 private:
  std::vector<ConvexPolygon<Scalar>> polygons_;
  std::vector<ShapeCorners<Scalar>> corners_;
  std::vector<std::uint8_t> kinds_;
  std::vector<std::uint8_t> counts_;
  std::vector<Scalar> radii_;
  bool has_radius_ = false;
};

/// A shape as one pair at a time takes it: a row for each coordinate, so that a vector holds a
/// coordinate of every face. The places past the last corner repeat the first, which changes no
/// result: of equals, the first counts.
struct alignas(64) ShapeRows {
  float x[kMaxVertices];                ///< of each vertex
  float y[kMaxVertices];                ///< of each vertex
  float normal_x[kMaxVertices];         ///< of each face
  float normal_y[kMaxVertices];         ///< of each face
  int count = 0;                        ///< of vertices
  float radius = 0;                     ///< a length, >= 0
  Rounding rounding = Rounding::mitre;  ///< of corners
};

/// A shape, laid out in its own frame.
ShapeRows rows_of(const ConvexPolygon<float>& polygon);

/// The shape that was laid out.
ConvexPolygon<float> polygon_of(const ShapeRows& rows);

}  // namespace manifuzz::kernel
