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

/// How a pair of shapes is collided: all pairs of a batch alike.
enum class PairKind : std::uint8_t {
  sharp,            ///< two mitred polygons
  cores,            ///< both have faces, and one of them is round, or both are
  core_and_circle,  ///< A has faces, B is a circle
  circle_and_core,  ///< A is a circle, B has faces
  circles,          ///< two circles
};

/// How many kinds of pairs there are.
inline constexpr unsigned kPairKinds = 5;

/// Groups of pairs are numbered from 0: by A's vertices and B's, first mitred polygons among
/// themselves, then pairs with a round shape.
inline constexpr unsigned kPairGroups = 2 * kMaxVertices * kMaxVertices;

/// What the pairs of a group are.
constexpr PairKind kind_of_group(unsigned group) {
  if (group < kPairGroups / 2) return PairKind::sharp;
  const bool a_is_circle = group / kMaxVertices % kMaxVertices == 0;
  const bool b_is_circle = group % kMaxVertices == 0;
  if (a_is_circle) return b_is_circle ? PairKind::circles : PairKind::circle_and_core;
  return b_is_circle ? PairKind::core_and_circle : PairKind::cores;
}

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
  /// The group of a pair of these shapes: those of a group go through the kernels together.
  unsigned group(std::uint32_t a, std::uint32_t b) const {
    constexpr unsigned of_a = kPairGroups - kMaxVertices;
    constexpr unsigned of_b = kPairGroups / 2 + kMaxVertices - 1;
    return (kinds_[a] & of_a) | (kinds_[b] & of_b);
  }
  /// How many vertices a shape has.
  unsigned count(std::uint32_t shape) const { return counts_[shape]; }
  /// A shape's radius, a length.
  Scalar radius(std::uint32_t shape) const { return radii_[shape]; }
  bool has_radius() const { return has_radius_; }  ///< of any shape: it is not 0

 private:
  std::vector<ConvexPolygon<Scalar>> polygons_;
  std::vector<ShapeCorners<Scalar>> corners_;
  std::vector<std::uint8_t> kinds_;  // the group of a pair of two of them
  std::vector<std::uint8_t> counts_;
  std::vector<Scalar> radii_;
  bool has_radius_ = false;
};

/// A shape as one pair at a time takes it: a row for each coordinate, so that a vector holds a
/// coordinate of every face. The places past the last corner repeat the first, which changes no
/// result: of equals, the first counts. Aligned as one row is: aligned to 64, each shape would end
/// in 32 bytes of nothing.
struct alignas(32) ShapeRows {
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

/// The shape that was laid out. Places past the last corner are copied as well: a loop of known
/// length goes through vectors.
inline ConvexPolygon<float> polygon_of(const ShapeRows& rows) {
  ConvexPolygon<float> polygon;
  for (int i = 0; i < kMaxVertices; ++i) {
    polygon.vertices[i] = {rows.x[i], rows.y[i]};
    polygon.normals[i] = {rows.normal_x[i], rows.normal_y[i]};
  }
  polygon.count = rows.count;
  polygon.radius = rows.radius;
  polygon.rounding = rows.rounding;
  return polygon;
}

}  // namespace manifuzz::kernel
