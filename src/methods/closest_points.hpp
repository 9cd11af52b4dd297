#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "clipping/curved_shapes.hpp"
#include "methods/epa.hpp"
#include "methods/nearest_faces.hpp"
#include "methods/shrink.hpp"

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

/// The contact at the face that separates most, or at one that rounding cannot tell from it, where
/// the other core is nearest between the face's ends; none where it is so at no face. The depth is
/// that of the greatest separation.
template <class Scalar>
std::optional<Manifold<Scalar>> contact_inside_faces(const ConvexPolygon<Scalar>& a,
                                                     const ConvexPolygon<Scalar>& b,
                                                     const NearestFaces<Scalar>& faces,
                                                     PlaceAtFace what, Scalar roundoff) {
  const Scalar separation = faces.separation();
  const FoundFace<Scalar>* best = nullptr;
  PlaceOfOther<Scalar> place_at_best;
  for (const FoundFace<Scalar>& face : std::span(faces.all.data(), faces.count)) {
    if (face.found.separation < separation - roundoff) continue;
    if (best != nullptr && face.found.separation <= best->found.separation) continue;
    const ConvexPolygon<Scalar>& polygon = face.side == Side::a ? a : b;
    const ConvexPolygon<Scalar>& other = face.side == Side::a ? b : a;
    const auto place = place_inside_face(polygon, face.found, other, what, separation + roundoff);
    if (!place) continue;
    best = &face;
    place_at_best = *place;
  }
  if (best == nullptr) return std::nullopt;
  return contact_at_face(a, b, best->side, best->found.face, separation, place_at_best);
}

/// The contact at the deepest vertex of the face that separates most.
template <class Scalar>
Manifold<Scalar> contact_at_deepest(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                                    const NearestFaces<Scalar>& faces) {
  const auto [side, found] = faces.greatest();
  const Vector2<Scalar>& deepest = (side == Side::a ? b : a).vertices[found.deepest];
  return contact_at_face<Scalar>(
      a, b, side, found.face, found.separation,
      {deepest, clipping::face(found.face), clipping::vertex(found.deepest)});
}

/// Of two points at one place any direction is a normal: (1, 0).
template <class Scalar>
Manifold<Scalar> contact_of_same_points(const ConvexPolygon<Scalar>& a,
                                        const ConvexPolygon<Scalar>& b) {
  Manifold<Scalar> manifold;
  manifold.count = 1;
  manifold.normal = {1, 0};
  manifold.points[0] = {b.vertices[0], a.radius + b.radius, {}};
  clipping::put_on_surface(a, b, manifold);
  return manifold;
}

/// Of cores that overlap, from the nearest edge of their difference's outline.
template <class Scalar>
Manifold<Scalar> contact_of_overlap(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                                    const Simplex& edge, Scalar roundoff) {
  if (a.face_count() + b.face_count() == 0) return contact_of_same_points(a, b);
  const NearestFaces<Scalar> faces = nearest_faces(a, b, edge);
  const auto inside = contact_inside_faces(a, b, faces, PlaceAtFace::on_edge, roundoff);
  return inside ? *inside : contact_at_deepest(a, b, faces);
}

/// Two vertices as places.
template <class Scalar>
clipping::NearestPlaces<Scalar> places_of(const ConvexPolygon<Scalar>& a,
                                          const ConvexPolygon<Scalar>& b, SupportPair pair) {
  return {a.vertices[pair.a],
          b.vertices[pair.b],
          b.vertices[pair.b] - a.vertices[pair.a],
          {clipping::vertex(pair.a), clipping::vertex(pair.b)}};
}

/// Of mitred polygons that are nearest at two vertices. Skins touch along faces alone, and each
/// reaches past its core by the total radius along them, as side planes of clipping do: the contact
/// is on the incident skin where both reach it, and there is none where they do not.
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

/// Of round shapes whose cores are nearest at two vertices.
template <class Scalar>
Manifold<Scalar> contact_of_vertices(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                                     const NearestFaces<Scalar>& faces,
                                     const clipping::NearestPlaces<Scalar>& nearest,
                                     Scalar roundoff) {
  const auto normal = clipping::nearest_normal(a, b, faces.of_a, faces.of_b, nearest, roundoff);
  if (!normal) return contact_at_deepest(a, b, faces);
  return clipping::nearest_contact(a, b, nearest, *normal, roundoff, SecondPoint::never());
}

/// A face and the other core's deepest vertex, as a simplex.
template <class Scalar>
Simplex simplex_of(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                   const FoundFace<Scalar>& face) {
  const auto index = [](int i) { return static_cast<unsigned char>(i); };
  const auto [side, found] = face;
  const unsigned char deepest = index(found.deepest);
  const unsigned char first = index(found.face);
  if (side == Side::a) {
    return {{{{first, deepest}, {index(a.next(found.face)), deepest}, {}}}, 2};
  }
  return {{{{deepest, first}, {deepest, index(b.next(found.face))}, {}}}, 2};
}

/// Of cores that are apart, from the feature of their difference that is nearest, `hint`. Where a
/// face separates mitred skins, it is the next step's hint.
template <class Scalar>
Manifold<Scalar> contact_of_apart(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                                  Simplex& hint, Scalar roundoff) {
  const Simplex feature = hint;
  auto vertices = places_of(a, b, feature.vertices[0]);
  Simplex settled = feature;
  if (feature.count == 1) {
    clipping::settle_vertices(a, b, vertices);
    settled.vertices[0] = {vertices.features.a.index, vertices.features.b.index};
  }
  const NearestFaces<Scalar> faces = nearest_faces(a, b, settled);
  if (!are_round(a, b) && faces.separation() > a.radius + b.radius) {
    hint = simplex_of(a, b, faces.greatest());
    return {};
  }
  if (a.face_count() + b.face_count() > 0) {
    const auto what = are_round(a, b) ? PlaceAtFace::corner : PlaceAtFace::on_edge;
    const auto inside = contact_inside_faces(a, b, faces, what, roundoff);
    if (inside) return *inside;
  }
  if (feature.count == 2) clipping::settle_vertices(a, b, vertices);
  return are_round(a, b) ? contact_of_vertices(a, b, faces, vertices, roundoff)
                         : contact_of_skins(a, b, faces, vertices);
}

/// The contact of two shapes that stand in one frame, by the closest points of their cores: the
/// article's first way without clipping. `hint` is what the last step left, and is left for the
/// next.
template <class Scalar>
PointContact<Scalar> contact_by_gjk(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                                    Simplex& hint) {
  PointContact<Scalar> contact;
  const auto total_radius = static_cast<double>(a.radius) + static_cast<double>(b.radius);
  // Mitred skins reach past their cores' corners by more than they are thick.
  const bool is_limited = total_radius == 0 || are_round(a, b);
  const double limit = is_limited ? total_radius : std::numeric_limits<double>::infinity();
  const GjkResult found = gjk(a, b, hint, limit);
  hint = found.simplex;
  contact.gjk_iterations = found.iterations;
  if (found.apartness == Apartness::separated) return contact;
  const Scalar roundoff = clipping::separation_roundoff(a, b);
  if (found.apartness == Apartness::apart) {
    contact.manifold = contact_of_apart(a, b, hint, roundoff);
    return contact;
  }
  const EpaResult nearest = epa(a, b, found.simplex);
  contact.epa_iterations = nearest.iterations;
  contact.manifold = contact_of_overlap(a, b, nearest.edge, roundoff);
  return contact;
}

/// The same with B standing at `b_in_a` in A's frame (see `relative_pose`), whose rotation is taken
/// to be unit. What the last step's direction still separates costs least.
template <class Scalar>
PointContact<Scalar> contact_by_gjk(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                                    const Pose<Scalar>& b_in_a, Simplex& hint) {
  const Scalar total_radius = a.radius + b.radius;
  const bool may_separate = total_radius == 0 || are_round(a, b) || is_face(a, b, hint);
  if (may_separate && separates(hint, a, b, b_in_a, total_radius)) return {{}, 1, 0};
  return contact_by_gjk(a, transform(b_in_a, b), hint);
}

}  // namespace manifuzz::methods
