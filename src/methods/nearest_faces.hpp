#pragma once

#include <algorithm>
#include <optional>

#include "clipping/nearest.hpp"
#include "methods/gjk.hpp"

// From what GJK and EPA find, which are vertices, to faces with their own normals: the separation
// along these is as accurate as that of clipping, and no search over all faces is needed.

namespace manifuzz::methods {

/// The faces of greatest separation, A's and B's, among those at or between a feature's vertices.
template <class Scalar>
struct NearestFaces {
  clipping::FaceSeparation<Scalar> of_a;  ///< minus infinity where A is a point
  clipping::FaceSeparation<Scalar> of_b;  ///< the same of B

  /// Whether A's separates at least as much.
  bool is_of_a() const { return of_a.separation >= of_b.separation; }
  /// The greater separation.
  Scalar separation() const { return std::max(of_a.separation, of_b.separation); }
};

/// The face of greatest separation from the one before vertex `first` to the one after vertex
/// `last`, counter-clockwise; the first of equals.
template <class Scalar>
clipping::FaceSeparation<Scalar> greatest_between(const ConvexPolygon<Scalar>& core, int first,
                                                  int last, const ConvexPolygon<Scalar>& other) {
  if (core.face_count() == 0) return {};
  auto greatest = clipping::face_separation(core, core.previous(first), other);
  for (int i = first;; i = core.next(i)) {
    const auto found = clipping::face_separation(core, i, other);
    if (found.separation > greatest.separation) greatest = found;
    if (i == last) return greatest;
  }
}

/// Of the feature of 1 or 2 vertices of the difference that is nearest to the origin. A face's
/// separation is never more than the true one, so that looking at too many faces does no harm; and
/// the nearest face is among these, since the difference's outline between its vertices consists of
/// faces of A and B between theirs.
template <class Scalar>
NearestFaces<Scalar> nearest_faces(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                                   const Simplex& feature) {
  const SupportPair first = feature.vertices[0];
  const SupportPair last = feature.vertices[feature.count - 1];
  return {greatest_between(a, first.a, last.a, b), greatest_between(b, first.b, last.b, a)};
}

/// Where a face and the other core are nearest, if that is in front of the face, or behind it,
/// between its ends: at the other's deepest vertex, or where an edge from there crosses the end's
/// side plane without rising by more than `roundoff`, a length; nothing where there is no such
/// place.
template <class Scalar>
std::optional<clipping::NearestPlaces<Scalar>> places_inside_face(
    const ConvexPolygon<Scalar>& polygon, Side side, const clipping::FaceSeparation<Scalar>& found,
    const ConvexPolygon<Scalar>& other, Scalar roundoff) {
  const Vector2<Scalar>& normal = polygon.normals[found.face];
  const Vector2<Scalar>& from = polygon.vertices[found.face];
  const Vector2<Scalar> along = counter_clockwise_quarter(normal);
  const Scalar length = along.dot(polygon.vertices[polygon.next(found.face)] - from);
  Vector2<Scalar> place = other.vertices[found.deepest];
  FeaturePair features{clipping::face(found.face), clipping::vertex(found.deepest)};
  Scalar at = along.dot(place - from);
  const bool is_before = at < 0;
  const Scalar end = is_before ? 0 : length;
  // The other's edges run against the face: what is farther along it comes before.
  for (int j = found.deepest; at < 0 || at > length;) {
    const int k = is_before ? other.previous(j) : other.next(j);
    const Scalar next_at = along.dot(other.vertices[k] - from);
    if (is_before ? next_at <= at : next_at >= at) return std::nullopt;
    if (is_before ? next_at >= end : next_at <= end) {
      const Scalar share = (end - at) / (next_at - at);
      place = other.vertices[j] + share * (other.vertices[k] - other.vertices[j]);
      features = {clipping::vertex(is_before ? found.face : polygon.next(found.face)),
                  clipping::face(is_before ? k : j)};
      break;
    }
    j = k;
    at = next_at;
  }
  const Scalar separation = normal.dot(place - from);
  if (separation > found.separation + roundoff) return std::nullopt;
  const Vector2<Scalar> out = separation * normal;
  const Vector2<Scalar> foot = place - out;
  if (side == Side::a) return clipping::NearestPlaces<Scalar>{foot, place, out, features};
  return clipping::NearestPlaces<Scalar>{place, foot, -out, {features.b, features.a}};
}

}  // namespace manifuzz::methods
