#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "collider/used_shapes.hpp"

namespace manifuzz::exact {

// Where the stored numbers put the polygons: R v + p with R the matrix of (cos, sin) as it is, in
// any number type, seen from A's position. Whatever is asked for is computed from what is stored:
// floats, or doubles where an engine has made the polygons its own.

/// A polygon as it is stored, in doubles; every float is one.
struct StoredPolygon {
  std::array<Vector2<double>, kMaxVertices> vertices;
  int count = 0;
  double radius = 0;

  int face_count() const { return count > 1 ? count : 0; }
  int next(int i) const { return i + 1 < count ? i + 1 : 0; }
  int previous(int i) const { return i > 0 ? i - 1 : count - 1; }
};

struct StoredBody {
  StoredPolygon polygon;
  Pose<float> pose;
};

struct StoredPair {
  StoredBody a;
  StoredBody b;

  const StoredBody& operator[](Side side) const { return side == Side::a ? a : b; }
};

StoredPair stored(const PairCase& pair);
/// With the vertices that an engine made of the polygons, kMinVertices to kMaxVertices of each.
StoredPair stored(const PairCase& pair, const UsedShapes& used);

template <class Number>
struct Point {
  Number x{0.0};
  Number y{0.0};

  friend Point operator+(const Point& p, const Point& q) { return {p.x + q.x, p.y + q.y}; }
  friend Point operator-(const Point& p, const Point& q) { return {p.x - q.x, p.y - q.y}; }
};

template <class Number>
Number dot(const Point<Number>& p, const Point<Number>& q) {
  return p.x * q.x + p.y * q.y;
}

using manifuzz::cross;  // the one below would hide it
/// z of p x q: positive where q points counter-clockwise of p.
template <class Number>
Number cross(const Point<Number>& p, const Point<Number>& q) {
  return p.x * q.y - p.y * q.x;
}

template <class Number>
Number widen(double value) {
  return Number(value);
}
template <class Number>
Number widen(float value) {
  return Number(static_cast<double>(value));
}

template <class Number, class Scalar>
Point<Number> widen(const Vector2<Scalar>& v) {
  return {widen<Number>(v.x()), widen<Number>(v.y())};
}

// A body, or a pair, is one of floats or one that is stored in doubles.

/// R v.
template <class Number, class AnyBody>
Point<Number> turned(const AnyBody& body, const Point<Number>& v) {
  const Point<Number> r = widen<Number>(body.pose.rotation);
  return {r.x * v.x - r.y * v.y, r.y * v.x + r.x * v.y};
}

/// R^T v.
template <class Number, class AnyBody>
Point<Number> turned_back(const AnyBody& body, const Point<Number>& v) {
  const Point<Number> r = widen<Number>(body.pose.rotation);
  return {r.x * v.x + r.y * v.y, r.x * v.y - r.y * v.x};
}

/// cos^2 + sin^2.
template <class Number, class AnyBody>
Number scale(const AnyBody& body) {
  const Point<Number> r = widen<Number>(body.pose.rotation);
  return dot(r, r);
}

/// A face or an edge of one polygon.
struct FaceOf {
  Side side = Side::a;
  int index = 0;

  friend bool operator==(const FaceOf&, const FaceOf&) = default;
};

/// A's faces, then B's.
inline std::vector<FaceOf> all_faces(const StoredPair& pair) {
  std::vector<FaceOf> faces;
  for (const Side side : {Side::a, Side::b}) {
    for (int i = 0; i < pair[side].polygon.face_count(); ++i) faces.push_back({side, i});
  }
  return faces;
}

/// A vertex in the world, from A's position.
template <class Number, class AnyPair>
Point<Number> vertex(const AnyPair& pair, Side side, int index) {
  const Point<Number> at = turned(pair[side], widen<Number>(pair[side].polygon.vertices[index]));
  if (side == Side::a) return at;
  return at + (widen<Number>(pair.b.pose.position) - widen<Number>(pair.a.pose.position));
}

/// A face's direction in the world, counter-clockwise, as long as the face.
template <class Number, class AnyPair>
Point<Number> direction(const AnyPair& pair, FaceOf face) {
  const auto& polygon = pair[face.side].polygon;
  return turned(pair[face.side], widen<Number>(polygon.vertices[polygon.next(face.index)]) -
                                     widen<Number>(polygon.vertices[face.index]));
}

/// A face's outward normal in the world, as long as the face.
template <class Number, class AnyPair>
Point<Number> outward(const AnyPair& pair, FaceOf face) {
  const Point<Number> along = direction<Number>(pair, face);
  return {along.y, -along.x};
}

/// The same, or turned about where the face is B's: it points from A to B.
template <class Number, class AnyPair>
Point<Number> outward_from_a(const AnyPair& pair, FaceOf face) {
  const Point<Number> out = outward<Number>(pair, face);
  return face.side == Side::a ? out : Point<Number>{-out.x, -out.y};
}

/// The square of a face's length.
template <class Number, class AnyPair>
Number square(const AnyPair& pair, FaceOf face) {
  const Point<Number> along = direction<Number>(pair, face);
  return dot(along, along);
}

/// The distance of the other polygon's vertex in front of a face, times the face's length.
template <class Number, class AnyPair>
Number scaled_separation(const AnyPair& pair, FaceOf face, int opposing) {
  const Point<Number> corner = vertex<Number>(pair, face.side, face.index);
  return dot(outward<Number>(pair, face),
             vertex<Number>(pair, other(face.side), opposing) - corner);
}

template <class Number, class AnyPair>
Number total_radius(const AnyPair& pair) {
  return widen<Number>(pair.a.polygon.radius) + widen<Number>(pair.b.polygon.radius);
}

// Where the polygons stand, in double: for pictures, and as the filter of exact decisions.

/// A polygon in world directions, seen from A's position; unit outward normals, (0, 0) of a point.
struct RoughPolygon {
  std::array<Vector2<double>, kMaxVertices> vertices;
  std::array<Vector2<double>, kMaxVertices> normals;
  int count = 0;

  int face_count() const { return count > 1 ? count : 0; }
  int next(int i) const { return i + 1 < count ? i + 1 : 0; }
  int previous(int i) const { return i > 0 ? i - 1 : count - 1; }
  std::vector<Vector2<double>> corners() const {
    return {vertices.begin(), vertices.begin() + count};
  }
};

struct RoughPair {
  RoughPolygon a;
  RoughPolygon b;

  const RoughPolygon& operator[](Side side) const { return side == Side::a ? a : b; }
};

RoughPair place_roughly(const StoredPair& pair);
inline RoughPair place_roughly(const PairCase& pair) {
  return place_roughly(stored(pair));
}

/// A place or direction of A's frame, in world directions.
inline Vector2<double> seen_from_a(const PairCase& pair, const Vector2<double>& local) {
  return rotate<double>(pair.a.pose.rotation.cast<double>(), local);
}

/// The angle between two directions, in radians.
inline double angle_between(const Vector2<double>& p, const Vector2<double>& q) {
  return std::abs(std::atan2(cross(p, q), p.dot(q)));
}

/// How far along a segment, as a share of it, the place on it is that is nearest to another.
inline double share_along_segment(const Vector2<double>& place, const Vector2<double>& from,
                                  const Vector2<double>& to) {
  const Vector2<double> along = to - from;
  const double square = along.dot(along);
  return square > 0 ? std::clamp((place - from).dot(along) / square, 0.0, 1.0) : 0.0;
}

/// The place on a segment that is nearest to another.
inline Vector2<double> nearest_on_segment(const Vector2<double>& place, const Vector2<double>& from,
                                          const Vector2<double>& to) {
  return from + share_along_segment(place, from, to) * (to - from);
}

/// How far a place is from a segment.
inline double distance_to_segment(const Vector2<double>& place, const Vector2<double>& from,
                                  const Vector2<double>& to) {
  return (place - from - share_along_segment(place, from, to) * (to - from)).norm();
}

/// The separation of every face of both polygons, within one proven error.
struct Separations {
  std::array<std::array<double, kMaxVertices>, 2> of_face;
  std::array<double, 2> greatest;  ///< per side; of a point minus infinity
  double extent = 0;               ///< of the pair
  double error = 0;                ///< of each of them, a world length
};

/// The separations of the stored floats, exactly as they are.
Separations separations(const PairCase& pair);
/// `extent` is that of the pair.
Separations separations(const StoredPair& pair, double extent);

/// How far the dot of two of the unit normals may be off.
inline constexpr double kErrorOfDot = 0x1p-48;

}  // namespace manifuzz::exact
