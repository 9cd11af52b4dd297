#pragma once

#include <limits>

#include "geometry/convex_polygon.hpp"
#include "geometry/manifold.hpp"

namespace manifuzz::clipping {

/// A face and how far the other polygon lies in front of it.
template <class Scalar>
struct FaceSeparation {
  int face = 0;                                                  ///< its index
  Scalar separation = -std::numeric_limits<Scalar>::infinity();  ///< along the normal; < 0 overlaps
  int deepest = 0;                                               ///< the other polygon's vertex
};

/// The signed distance from a face to the other polygon's deepest vertex, the first of equals:
/// negative where that lies behind the face. Both in one frame, radii left out. The difference
/// comes first: it is what keeps the rounding relative to the distance.
template <class Scalar>
FaceSeparation<Scalar> face_separation(const ConvexPolygon<Scalar>& polygon, int face,
                                       const ConvexPolygon<Scalar>& other) {
  const Vector2<Scalar>& normal = polygon.normals[face];
  const Vector2<Scalar>& origin = polygon.vertices[face];
  FaceSeparation<Scalar> result{face, std::numeric_limits<Scalar>::infinity(), 0};
  for (int j = 0; j < other.count; ++j) {
    const Scalar distance = normal.dot(other.vertices[j] - origin);
    if (distance < result.separation) {
      result.separation = distance;
      result.deepest = j;
    }
  }
  return result;
}

/// Calls `visit(side, polygon, face, opposing)` for each face of A, then of B: whose it is, that
/// polygon, the face's index, and the other polygon.
template <class Scalar, class Visit>
void for_each_face(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                   const Visit& visit) {
  for (int i = 0; i < a.face_count(); ++i) visit(Side::a, a, i, b);
  for (int i = 0; i < b.face_count(); ++i) visit(Side::b, b, i, a);
}

/// The face of greatest separation, the first of equals. Stops at the first face that separates by
/// more than `limit`, a length, which need not be the greatest. (The article's separating axes,
/// faces only; Box2D: b2FindMaxSeparation.)
template <class Scalar>
FaceSeparation<Scalar> greatest_separation(const ConvexPolygon<Scalar>& polygon,
                                           const ConvexPolygon<Scalar>& other, Scalar limit) {
  FaceSeparation<Scalar> greatest;
  for (int i = 0; i < polygon.count; ++i) {
    const FaceSeparation<Scalar> candidate = face_separation(polygon, i, other);
    if (candidate.separation > greatest.separation) greatest = candidate;
    if (candidate.separation > limit) break;
  }
  return greatest;
}

}  // namespace manifuzz::clipping
