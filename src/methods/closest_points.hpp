#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "clipping/circle_contact.hpp"
#include "methods/nearest_features.hpp"

namespace manifuzz::methods {

/// A contact of one point, and what it took.
template <class Scalar>
struct PointContact {
  Manifold<Scalar> manifold;  ///< of 0 or 1 points, in A's frame
  int gjk_iterations = 0;     ///< supports that GJK asked for
  int epa_iterations = 0;     ///< supports that EPA asked for; 0 where cores are apart
};

/// The manifold of one point at a face, with its normal and a separation, or none where that is
/// more than the total radius. `place` is on the other core, in their common frame.
template <class Scalar>
Manifold<Scalar> contact_at_face(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                                 Side side, int face, Scalar separation,
                                 const PlaceOfOther<Scalar>& place) {
  const Scalar total_radius = a.radius + b.radius;
  if (separation > total_radius) return {};
  const bool is_of_a = side == Side::a;
  Manifold<Scalar> manifold;
  manifold.count = 1;
  manifold.reference = side;
  manifold.normal = is_of_a ? a.normals[face] : Vector2<Scalar>(-b.normals[face]);
  manifold.points[0] = {place.position, total_radius - separation,
                        is_of_a ? FeaturePair{place.of_face, place.of_other}
                                : FeaturePair{place.of_other, place.of_face}};
  if (are_round(a, b)) clipping::put_on_surface(a, b, manifold);
  return manifold;
}

/// By how much of its length a placed core's normals, and separations along them, are off: those of
/// a rotation that is not quite unit are as long as it is.
template <class Scalar>
Scalar stretch_of_normals(const ConvexPolygon<Scalar>& placed) {
  if (placed.face_count() == 0) return 0;
  return std::abs(placed.normals[0].squaredNorm() - 1) / 2;
}

/// The contact at the face that separates most, or at one that rounding cannot tell from it, where
/// the other core is nearest between the face's ends; none where it is so at no face. The depth is
/// that of the greatest separation.
template <class Scalar>
std::optional<Manifold<Scalar>> contact_inside_faces(const ConvexPolygon<Scalar>& a,
                                                     const ConvexPolygon<Scalar>& b,
                                                     const NearestFaces<Scalar>& faces,
                                                     PlaceAtFace what, Scalar roundoff) {
  const Scalar separation = faces.separation();
  const Scalar apart = 2 * roundoff + std::abs(separation) * stretch_of_normals(b);
  const FoundFace<Scalar>* best = nullptr;
  PlaceOfOther<Scalar> place_at_best;
  for (const FoundFace<Scalar>& face : std::span(faces.all.data(), faces.count)) {
    if (face.found.separation < separation - apart) continue;
    if (best != nullptr && face.found.separation <= best->found.separation) continue;
    const ConvexPolygon<Scalar>& polygon = face.side == Side::a ? a : b;
    const ConvexPolygon<Scalar>& other = face.side == Side::a ? b : a;
    const auto place = place_inside_face(polygon, face.found, other, what, separation + apart);
    if (!place) continue;
    best = &face;
    place_at_best = *place;
  }
  if (best == nullptr) return std::nullopt;
  return contact_at_face(a, b, best->side, best->found.face, separation, place_at_best);
}

/// How far a point lies past the ends of a face, along it; 0 between them.
template <class Scalar>
Scalar past_ends(const ConvexPolygon<Scalar>& polygon, int face, const Vector2<Scalar>& point) {
  const Vector2<Scalar> along = clipping::along_face(polygon, face);
  return std::max({along.dot(polygon.vertices[face] - point),
                   along.dot(point - polygon.vertices[polygon.next(face)]), Scalar(0)});
}

/// The other core's deepest vertex behind a face or, where that lies past the face's ends by more
/// than `roundoff`, of those as deep but for it the one that does so least.
template <class Scalar>
int deepest_before_face(const ConvexPolygon<Scalar>& polygon,
                        const clipping::FaceSeparation<Scalar>& found,
                        const ConvexPolygon<Scalar>& other, Scalar roundoff) {
  int deepest = found.deepest;
  Scalar past = past_ends(polygon, found.face, other.vertices[deepest]);
  if (past <= roundoff) return deepest;
  for (int j = 0; j < other.count; ++j) {
    const Vector2<Scalar>& corner = other.vertices[j];
    const Scalar separation =
        polygon.normals[found.face].dot(corner - polygon.vertices[found.face]);
    if (separation > found.separation + roundoff) continue;
    const Scalar past_here = past_ends(polygon, found.face, corner);
    if (past_here >= past) continue;
    past = past_here;
    deepest = j;
  }
  return deepest;
}

/// The contact at the deepest vertex of the face that separates most.
template <class Scalar>
Manifold<Scalar> contact_at_deepest(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                                    const NearestFaces<Scalar>& faces, Scalar roundoff) {
  const auto [side, found] = faces.greatest();
  const ConvexPolygon<Scalar>& polygon = side == Side::a ? a : b;
  const ConvexPolygon<Scalar>& other = side == Side::a ? b : a;
  const int deepest = deepest_before_face(polygon, found, other, roundoff);
  return contact_at_face<Scalar>(
      a, b, side, found.face, found.separation,
      {other.vertices[deepest], clipping::face(found.face), clipping::vertex(deepest)});
}

/// The contact of mitred polygons that are nearest at two vertices. Skins touch along faces alone,
/// and each reaches past its core by the total radius along them, as side planes of clipping do:
/// the contact is on the incident skin where both reach it, and there is none where they do not.
template <class Scalar>
Manifold<Scalar> contact_of_skins(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                                  const NearestFaces<Scalar>& faces,
                                  const clipping::NearestPlaces<Scalar>& nearest) {
  const auto [side, found] = faces.greatest();
  const bool is_of_a = side == Side::a;
  const Scalar reach = a.radius + b.radius;
  const Vector2<Scalar> along = counter_clockwise_quarter((is_of_a ? a : b).normals[found.face]);
  const Vector2<Scalar>& corner = is_of_a ? nearest.on_a : nearest.on_b;
  const Vector2<Scalar>& incident = is_of_a ? nearest.on_b : nearest.on_a;
  const Scalar off = along.dot(incident - corner);
  const Scalar past = std::abs(off) - reach;
  if (past > reach) return {};
  const Scalar back = std::copysign(std::max(past, Scalar(0)), off);
  return contact_at_face<Scalar>(a, b, side, found.face, found.separation,
                                 {incident - back * along, clipping::face(found.face),
                                  is_of_a ? nearest.features.b : nearest.features.a});
}

/// The contact of round shapes whose cores are nearest at two vertices, as GJK says. Where these
/// are not nearest, rounding took a vertex for a face's deepest that is far along it: places are
/// looked for as clipping does.
template <class Scalar>
Manifold<Scalar> contact_of_vertices(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                                     const NearestFaces<Scalar>& faces,
                                     const clipping::NearestPlaces<Scalar>& vertices,
                                     Scalar roundoff) {
  const clipping::NearestPlaces<Scalar> nearest =
      clipping::are_nearest(a, b, vertices)
          ? vertices
          : clipping::nearest_places(a, b, faces.of_a, faces.of_b, roundoff);
  const auto normal = clipping::nearest_normal(a, b, faces.of_a, faces.of_b, nearest, roundoff);
  if (!normal) return contact_at_deepest(a, b, faces, roundoff);
  return clipping::nearest_contact(a, b, nearest, *normal, roundoff, SecondPoint::never());
}

/// Where nothing is in front of a face: at two vertices; and of cores that overlap, at the deepest.
template <class Scalar>
Manifold<Scalar> contact_outside_faces(const ConvexPolygon<Scalar>& a,
                                       const ConvexPolygon<Scalar>& b,
                                       const NearestFeatures<Scalar>& nearest, Scalar roundoff) {
  if (clipping::is_circle(a) && clipping::is_circle(b)) return clipping::contact_of_circles(a, b);
  if (nearest.apartness == Apartness::overlapping) {
    return contact_at_deepest(a, b, nearest.faces, roundoff);
  }
  return are_round(a, b) ? contact_of_vertices(a, b, nearest.faces, nearest.vertices, roundoff)
                         : contact_of_skins(a, b, nearest.faces, nearest.vertices);
}

/// The contact of two shapes that stand in one frame, by the closest points of their cores: the
/// article's first way without clipping. `hint` is what the last step left, and is left for the
/// next.
template <class Scalar>
PointContact<Scalar> contact_by_gjk(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                                    Simplex& hint) {
  const NearestFeatures<Scalar> nearest = nearest_features(a, b, hint);
  PointContact<Scalar> contact{{}, nearest.gjk_iterations, nearest.epa_iterations};
  if (nearest.apartness == Apartness::separated) return contact;
  const bool are_apart = nearest.apartness == Apartness::apart && are_round(a, b);
  const Scalar roundoff = clipping::separation_roundoff(a, b);
  const auto inside = contact_inside_faces(
      a, b, nearest.faces, are_apart ? PlaceAtFace::corner : PlaceAtFace::on_edge, roundoff);
  contact.manifold = inside ? *inside : contact_outside_faces(a, b, nearest, roundoff);
  return contact;
}

/// As above, with B standing at `b_in_a` in A's frame (see `relative_pose`), whose rotation is
/// taken to be unit. What the last step's direction still separates costs least.
template <class Scalar>
PointContact<Scalar> contact_by_gjk(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                                    const Pose<Scalar>& b_in_a, Simplex& hint) {
  const Scalar total_radius = a.radius + b.radius;
  const bool may_separate = total_radius == 0 || are_round(a, b) || is_face(a, b, hint);
  if (may_separate && separates(hint, a, b, b_in_a, total_radius)) return {{}, 1, 0};
  return contact_by_gjk(a, transform(b_in_a, b), hint);
}

}  // namespace manifuzz::methods
