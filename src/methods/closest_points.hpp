#pragma once

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

/// The manifold of one point where a face and the other core are nearest: the face's normal, and
/// its separation as exact as that of clipping.
template <class Scalar>
Manifold<Scalar> contact_at_face(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                                 Side side, const clipping::FaceSeparation<Scalar>& found,
                                 const Vector2<Scalar>& place, const FeaturePair& features) {
  const Scalar total_radius = a.radius + b.radius;
  if (found.separation > total_radius) return {};
  Manifold<Scalar> manifold;
  manifold.count = 1;
  manifold.reference = side;
  const Vector2<Scalar>& normal = (side == Side::a ? a : b).normals[found.face];
  manifold.normal = side == Side::a ? normal : Vector2<Scalar>(-normal);
  manifold.points[0] = {place, total_radius - found.separation, features};
  if (are_round(a, b)) clipping::put_on_surface(a, b, manifold);
  return manifold;
}

/// The contact at the face that separates most, or at one of the other side that rounding cannot
/// tell from it, if the other core is in front of its inside; none where neither has it there.
template <class Scalar>
std::optional<Manifold<Scalar>> contact_inside_faces(const ConvexPolygon<Scalar>& a,
                                                     const ConvexPolygon<Scalar>& b,
                                                     const NearestFaces<Scalar>& faces,
                                                     Scalar roundoff) {
  const Scalar least = faces.separation() - roundoff;
  for (const Side side : {faces.is_of_a() ? Side::a : Side::b, faces.is_of_a() ? Side::b : Side::a}) {
    const auto& found = side == Side::a ? faces.of_a : faces.of_b;
    const ConvexPolygon<Scalar>& polygon = side == Side::a ? a : b;
    const ConvexPolygon<Scalar>& other = side == Side::a ? b : a;
    if (polygon.face_count() == 0 || found.separation < least) continue;
    const auto places = places_inside_face(polygon, side, found, other, roundoff);
    if (!places) continue;
    return contact_at_face<Scalar>(a, b, side, found, side == Side::a ? places->on_b : places->on_a,
                                   places->features);
  }
  return std::nullopt;
}

/// The contact at the deepest vertex of the face that separates most.
template <class Scalar>
Manifold<Scalar> contact_at_deepest(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                                    const NearestFaces<Scalar>& faces) {
  if (faces.is_of_a()) {
    const auto& found = faces.of_a;
    return contact_at_face<Scalar>(a, b, Side::a, found, b.vertices[found.deepest],
                                   {clipping::face(found.face), clipping::vertex(found.deepest)});
  }
  const auto& found = faces.of_b;
  return contact_at_face<Scalar>(a, b, Side::b, found, a.vertices[found.deepest],
                                 {clipping::vertex(found.deepest), clipping::face(found.face)});
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
  const auto inside = contact_inside_faces(a, b, faces, roundoff);
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

/// Of cores that are nearest at two vertices. Mitred skins touch along faces alone.
template <class Scalar>
Manifold<Scalar> contact_of_vertices(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                                     const NearestFaces<Scalar>& faces,
                                     const clipping::NearestPlaces<Scalar>& nearest,
                                     Scalar roundoff) {
  if (!are_round(a, b)) {
    const Side side = faces.is_of_a() ? Side::a : Side::b;
    const auto& found = faces.is_of_a() ? faces.of_a : faces.of_b;
    return contact_at_face<Scalar>(a, b, side, found, side == Side::a ? nearest.on_b : nearest.on_a,
                                   nearest.features);
  }
  const auto normal = clipping::nearest_normal(a, b, faces.of_a, faces.of_b, nearest, roundoff);
  if (!normal) return contact_at_deepest(a, b, faces);
  return clipping::nearest_contact(a, b, nearest, *normal, roundoff, SecondPoint::never());
}

/// Of cores that are apart, from the feature of their difference that is nearest.
template <class Scalar>
Manifold<Scalar> contact_of_apart(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                                  const Simplex& feature, Scalar roundoff) {
  auto vertices = places_of(a, b, feature.vertices[0]);
  Simplex settled = feature;
  if (feature.count == 1) {
    clipping::settle_vertices(a, b, vertices);
    settled.vertices[0] = {vertices.features.a.index, vertices.features.b.index};
  }
  const NearestFaces<Scalar> faces = nearest_faces(a, b, settled);
  if (a.face_count() + b.face_count() > 0) {
    const auto inside = contact_inside_faces(a, b, faces, roundoff);
    if (inside) return *inside;
  }
  if (feature.count == 2) clipping::settle_vertices(a, b, vertices);
  return contact_of_vertices(a, b, faces, vertices, roundoff);
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
    contact.manifold = contact_of_apart(a, b, found.simplex, roundoff);
    return contact;
  }
  const EpaResult nearest = epa(a, b, found.simplex);
  contact.epa_iterations = nearest.iterations;
  contact.manifold = contact_of_overlap(a, b, nearest.edge, roundoff);
  return contact;
}

}  // namespace manifuzz::methods
