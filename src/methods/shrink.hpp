#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "geometry/convex_polygon.hpp"

namespace manifuzz::methods {

/// A polygon whose faces move inwards, each at the same speed: what its corners and faces are when
/// all have moved by `moved`. A face vanishes where its ends meet, and its neighbours become
/// neighbours; the polygon vanishes where less than three are left.
struct ShrinkingPolygon {
  std::array<Vector2<double>, kMaxVertices> corners;  ///< corner k is the start of face k
  std::array<Vector2<double>, kMaxVertices> normals;  ///< of the faces that are left, outward, unit
  int count = 0;                                      ///< of both
  double moved = 0;                                   ///< a length

  /// The face after this one, counted round.
  int next(int k) const { return k + 1 < count ? k + 1 : 0; }
  /// The face before this one, counted round.
  int previous(int k) const { return k > 0 ? k - 1 : count - 1; }
};

/// The polygon before its faces move.
template <class Scalar>
ShrinkingPolygon shrinking(const ConvexPolygon<Scalar>& polygon) {
  ShrinkingPolygon shape;
  shape.count = polygon.count;
  for (int k = 0; k < polygon.count; ++k) {
    shape.corners[k] = polygon.vertices[k].template cast<double>();
    const Vector2<double> to = polygon.vertices[polygon.next(k)].template cast<double>();
    shape.normals[k] = outward_normal(shape.corners[k], to);
  }
  return shape;
}

/// How far a corner moves along the face that begins there, as its faces move inwards by 1: the
/// tangent of half the angle by which the outline turns there. By whichever quotient loses no
/// digits.
inline double run_at_corner(const ShrinkingPolygon& shape, int k) {
  const Vector2<double>& before = shape.normals[shape.previous(k)];
  const Vector2<double>& after = shape.normals[k];
  const double sine = cross(before, after);
  const double cosine = before.dot(after);
  return cosine > 0 ? sine / (1 + cosine) : (1 - cosine) / sine;
}

/// By how much faces can move until this one's ends meet.
inline double room_at_face(const ShrinkingPolygon& shape, int k) {
  const Vector2<double> along = counter_clockwise_quarter(shape.normals[k]);
  const double length = along.dot(shape.corners[shape.next(k)] - shape.corners[k]);
  return length / (run_at_corner(shape, k) + run_at_corner(shape, shape.next(k)));
}

/// The face that vanishes first, the first of equals.
inline int face_to_vanish(const ShrinkingPolygon& shape) {
  int first = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < shape.count; ++k) {
    const double room = room_at_face(shape, k);
    if (room >= least) continue;
    least = room;
    first = k;
  }
  return first;
}

/// Moves all faces inwards, by no more than the first of them has room for.
inline void move_faces(ShrinkingPolygon& shape, double by) {
  if (by == 0) return;  // faces that are about to meet may have no room, and corners no end
  ShrinkingPolygon moved = shape;
  for (int k = 0; k < shape.count; ++k) {
    const Vector2<double>& normal = shape.normals[k];
    moved.corners[k] += by * (run_at_corner(shape, k) * counter_clockwise_quarter(normal) - normal);
  }
  moved.moved += by;
  shape = moved;
}

/// Moves the faces of a polygon inwards by a length, or until less than three are left; what is
/// left then is a segment or a point, with the corners where they met.
inline void shrink_by(ShrinkingPolygon& shape, double by) {
  while (shape.count >= kMinVertices) {
    const int vanishing = face_to_vanish(shape);
    const double room = std::max(room_at_face(shape, vanishing), 0.0);
    if (shape.moved + room > by) {
      move_faces(shape, by - shape.moved);
      shape.moved = by;
      return;
    }
    move_faces(shape, room);
    for (int k = vanishing + 1; k < shape.count; ++k) {
      shape.corners[k - 1] = shape.corners[k];
      shape.normals[k - 1] = shape.normals[k];
    }
    --shape.count;
  }
}

/// The radius of the largest circle in a polygon's core, a length: by so much its faces can move
/// inwards until nothing is left. 0 of a segment and of a point.
template <class Scalar>
double inradius(const ConvexPolygon<Scalar>& polygon) {
  if (polygon.count < kMinVertices) return 0;
  ShrinkingPolygon shape = shrinking(polygon);
  shrink_by(shape, std::numeric_limits<double>::infinity());
  return shape.moved;
}

/// The corners as they are in the scalar, without those that do not turn left there, exactly: the
/// rounding of a sliver may put three on a line. Two are left at least of two unlike ones, else
/// one.
template <class Scalar>
ConvexPolygon<Scalar> convex_core(const ShrinkingPolygon& shape, Scalar radius) {
  std::array<Vector2<Scalar>, kMaxVertices> v;
  int count = 0;
  for (int k = 0; k < shape.count; ++k) v[count++] = shape.corners[k].template cast<Scalar>();
  for (int k = 0; count > 1 && k < count;) {
    const Vector2<Scalar>& before = v[k > 0 ? k - 1 : count - 1];
    const Vector2<Scalar>& after = v[k + 1 < count ? k + 1 : 0];
    const bool stays = count > 2 ? orientation(before, v[k], after) > 0 : before != v[k];
    if (stays) {
      ++k;
      continue;
    }
    std::copy(v.begin() + k + 1, v.begin() + count, v.begin() + k);
    --count;
    k = 0;
  }
  return make_polygon<Scalar>({v.data(), static_cast<std::size_t>(count)}, radius, Rounding::round);
}

/// A polygon shrunk by moving its faces inwards by a length, at most by its inradius, and the
/// length given back as rounding: its faces stand where they stood, and its corners are round. What
/// has no inside, a segment or a point, stays as it is.
///
/// Faces that vanish on the way leave the corner of their neighbours, which the outline turns round
/// as before. At the inradius a segment or a point is left, within it; then the radius is the
/// inradius. Corners are rounded to the scalar once.
template <class Scalar>
ConvexPolygon<Scalar> shrink(const ConvexPolygon<Scalar>& polygon, Scalar by) {
  if (polygon.count < kMinVertices || !(by > 0)) return polygon;
  ShrinkingPolygon shape = shrinking(polygon);
  shrink_by(shape, static_cast<double>(by));
  return convex_core<Scalar>(shape, polygon.radius + static_cast<Scalar>(shape.moved));
}

}  // namespace manifuzz::methods
