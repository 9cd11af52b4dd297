#pragma once

#include <array>
#include <cassert>
#include <optional>
#include <span>
#include <stdexcept>
#include <string_view>
#include <type_traits>
#include <variant>

#include "geometry/pose.hpp"
#include "geometry/vector.hpp"

namespace manifuzz {

/// The exact sign of the area of triangle abc: 1 counter-clockwise, -1 clockwise, 0 on one line.
/// After Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
/// Predicates" (1997): a filter first, then an expansion. Exact for every finite float; for doubles
/// while no product of two coordinates over- or underflows.
int orientation(const Vector2<double>& a, const Vector2<double>& b, const Vector2<double>& c);

template <class Scalar>
int orientation(const Vector2<Scalar>& a, const Vector2<Scalar>& b, const Vector2<Scalar>& c) {
  return orientation(Vector2<double>(a.template cast<double>()),
                     Vector2<double>(b.template cast<double>()),
                     Vector2<double>(c.template cast<double>()));
}

/// A polygon has at least so many vertices.
inline constexpr int kMinVertices = 3;
/// A polygon has at most so many vertices.
inline constexpr int kMaxVertices = 8;

/// What a radius adds to a core: a skin whose corners are as sharp as the core's (Box2D 2.4's
/// polygon radius), or one that is round at corners.
enum class Rounding : unsigned char { mitre, round };

/// A convex shape in its own frame: a core of 1 to 8 vertices, and a radius around it.
/// 3 to 8 vertices are a polygon, in counter-clockwise order, strictly convex, its corners mitred
/// or round. 2 are a segment, or with a radius a capsule; 1 is a circle's centre; both are always
/// round. Coordinates are lengths in the unit of the world.
/// Face i runs from vertex i to vertex i + 1; `normals[i]` is its outward unit normal. A segment
/// has two faces, one a side; a point has none. Plain data: build it with `make_polygon`, or
/// with `checked_polygon` where the numbers are not trusted.
template <class Scalar>
struct ConvexPolygon {
  std::array<Vector2<Scalar>, kMaxVertices> vertices;  ///< `count` of them, counter-clockwise
  std::array<Vector2<Scalar>, kMaxVertices> normals;   ///< of each face, outward, unit
  int count = 0;                                       ///< 1 to kMaxVertices
  Scalar radius = 0;                                   ///< a length, >= 0
  Rounding rounding = Rounding::mitre;                 ///< of corners

  /// How many faces there are.
  int face_count() const { return count > 1 ? count : 0; }
  /// Whether corners are round: a circle, a segment, a capsule, or a polygon that says so.
  bool is_round() const { return rounding == Rounding::round; }

  /// The index of the vertex, or face, after this one, counted round.
  int next(int i) const { return i + 1 < count ? i + 1 : 0; }
  /// The index of the vertex, or face, before this one, counted round.
  int previous(int i) const { return i > 0 ? i - 1 : count - 1; }
  /// The vertices.
  std::span<const Vector2<Scalar>> corners() const {
    return {vertices.data(), static_cast<std::size_t>(count)};
  }
};

/// Whether two shapes touch as round ones do; where both are mitred polygons, faces alone say how
/// deep they overlap.
template <class Scalar>
bool are_round(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b) {
  return a.is_round() || b.is_round();
}

/// What can be wrong with vertices, in the order in which it is looked for.
enum class PolygonDefect {
  too_few,              ///< less than kMinVertices
  too_many,             ///< more than kMaxVertices
  not_finite,           ///< a coordinate is infinite or not a number
  repeated_vertex,      ///< two vertices are equal
  clockwise,            ///< they turn the other way round
  not_strictly_convex,  ///< some corner turns clockwise, or not at all
  winds_twice,          ///< every corner turns the right way, and they go round more than once
  no_radius,            ///< one vertex, and nothing around it
  radius_not_a_length,  ///< below 0, infinite, or not a number
};

/// The first defect, or none. Decided exactly on the floats, without a tolerance: see
/// `orientation`.
std::optional<PolygonDefect> find_defect(std::span<const Vector2<float>> vertices);
/// The first defect of a polygon in doubles, as far as `orientation` is exact on them.
std::optional<PolygonDefect> find_defect_in_doubles(std::span<const Vector2<double>> vertices);

/// The first defect of a shape that may have less than 3 vertices, or none.
std::optional<PolygonDefect> find_shape_defect(std::span<const Vector2<float>> vertices,
                                               float radius);

/// One clause for a person: what is wrong, and what would be right.
std::string_view describe(PolygonDefect defect);

/// The outward unit normal of the counter-clockwise edge from `from` to `to`, in their frame,
/// computed in double and rounded once: off by one roundoff of float, in double by three.
template <class Scalar>
Vector2<Scalar> outward_normal(const Vector2<Scalar>& from, const Vector2<Scalar>& to) {
  const Vector2<double> edge = to.template cast<double>() - from.template cast<double>();
  if constexpr (std::is_same_v<Scalar, float>) {
    return clockwise_quarter(unit_direction_of_floats(edge));
  } else {
    return clockwise_quarter(unit_direction(edge));
  }
}

/// The shape with these vertices, rounded by `radius`. Both must be free of defects: what has some
/// makes a shape of no use, and no vertices or more than kMaxVertices throw std::invalid_argument.
/// Vertices are taken as they are, normals computed. Fewer than 3 vertices are round, whatever
/// `rounding` says.
template <class Scalar>
ConvexPolygon<Scalar> make_polygon(std::span<const Vector2<Scalar>> vertices, Scalar radius = 0,
                                   Rounding rounding = Rounding::mitre) {
  if (vertices.empty() || vertices.size() > kMaxVertices) {
    throw std::invalid_argument("make_polygon: a shape has 1 to 8 vertices");
  }
  assert(radius >= 0);
  ConvexPolygon<Scalar> polygon;
  polygon.count = static_cast<int>(vertices.size());
  polygon.radius = radius;
  polygon.rounding = polygon.count < kMinVertices ? Rounding::round : rounding;
  polygon.normals[0] = {0, 0};  // a point has no face
  for (int i = 0; i < polygon.count; ++i) polygon.vertices[i] = vertices[i];
  for (int i = 0; i < polygon.face_count(); ++i) {
    polygon.normals[i] = outward_normal(polygon.vertices[i], polygon.vertices[polygon.next(i)]);
  }
  return polygon;
}

/// The shape with these vertices, or its first defect: for numbers that are not trusted. Otherwise
/// as `make_polygon`.
std::variant<ConvexPolygon<float>, PolygonDefect> checked_polygon(
    std::span<const Vector2<float>> vertices, float radius = 0,
    Rounding rounding = Rounding::mitre);

/// A copy of the polygon in another scalar, its normals computed afresh in that one.
template <class To, class From>
ConvexPolygon<To> polygon_cast(const ConvexPolygon<From>& polygon) {
  std::array<Vector2<To>, kMaxVertices> vertices;
  for (int i = 0; i < polygon.count; ++i) vertices[i] = polygon.vertices[i].template cast<To>();
  return make_polygon<To>({vertices.data(), static_cast<std::size_t>(polygon.count)},
                          static_cast<To>(polygon.radius), polygon.rounding);
}

/// The polygon seen from the frame in which `pose` places it. The rotation is taken to be unit:
/// lengths, normals among them, come out times its length. Of float polygons, a vertex is off by up
/// to 2.5 roundoffs of its reach, and one of its sum with the position.
template <class Scalar>
ConvexPolygon<Scalar> transform(const Pose<Scalar>& pose, const ConvexPolygon<Scalar>& polygon) {
  ConvexPolygon<Scalar> placed;
  placed.count = polygon.count;
  placed.radius = polygon.radius;
  placed.rounding = polygon.rounding;
  for (int i = 0; i < polygon.count; ++i) {
    placed.vertices[i] = transform(pose, polygon.vertices[i]);
    placed.normals[i] = rotate(pose.rotation, polygon.normals[i]);
  }
  return placed;
}

/// Equal vertices in the same order, and equal radius and rounding.
template <class Scalar>
bool operator==(const ConvexPolygon<Scalar>& p, const ConvexPolygon<Scalar>& q) {
  if (p.count != q.count || p.radius != q.radius || p.rounding != q.rounding) return false;
  for (int i = 0; i < p.count; ++i) {
    if (p.vertices[i] != q.vertices[i]) return false;
  }
  return true;
}

/// The largest distance between two vertices, a length, the radius left out.
double diameter(const ConvexPolygon<float>& polygon);
/// The diameter of the polygon whose diameter is smaller, cheaper than both.
double smaller_diameter(const ConvexPolygon<float>& p, const ConvexPolygon<float>& q);

/// The shape's size, a length: the diameter of its core, and twice the radius where it is round.
double size(const ConvexPolygon<float>& polygon);

/// The largest distance of a vertex from the polygon's own origin, a length, the radius left out.
double reach(const ConvexPolygon<float>& polygon);

}  // namespace manifuzz
