#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
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

/// A place of the other core at a face, and how far it is off the deepest one, a length:
/// by how much it is less deep, or farther past the face's ends than side planes are widened,
/// whichever is more.
template <class Scalar>
struct PlaceOff {
  PlaceOfOther<Scalar> place;  ///< of the other core
  Scalar off = 0;              ///< >= 0, but for rounding
};

/// The other core's place that is least off at a face: a vertex, or where an edge leaves the slab
/// between the face's ends. Rounding, of placing the cores too, may take a vertex far along the
/// face for the deepest. `margin` is by how much side planes are widened, a length.
template <class Scalar>
PlaceOff<Scalar> least_off_at_face(const ConvexPolygon<Scalar>& polygon,
                                   const clipping::FaceSeparation<Scalar>& found,
                                   const ConvexPolygon<Scalar>& other, Scalar margin) {
  const auto less_deep = [&](const Vector2<Scalar>& place) {
    return polygon.normals[found.face].dot(place - polygon.vertices[found.face]) - found.separation;
  };
  const auto at_vertex = [&](int j) {
    const Vector2<Scalar>& corner = other.vertices[j];
    return PlaceOff<Scalar>{
        {corner, clipping::face(found.face), clipping::vertex(j)},
        std::max(less_deep(corner), past_ends(polygon, found.face, corner) - margin)};
  };
  PlaceOff<Scalar> least = at_vertex(found.deepest);
  for (int j = 0; j < other.count; ++j) {
    const PlaceOff<Scalar> here = at_vertex(j);
    if (here.off < least.off) least = here;
  }
  const auto inside =
      place_inside_face(polygon, found, other, PlaceAtFace::on_edge, found.separation + least.off);
  if (!inside) return least;
  const Scalar off_inside = less_deep(inside->position);
  return off_inside < least.off ? PlaceOff<Scalar>{*inside, off_inside} : least;
}

/// The contact where no place is the deepest, or nearest, before a face but for rounding: at the
/// face and place that are least off together.
template <class Scalar>
Manifold<Scalar> contact_at_deepest(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                                    const NearestFaces<Scalar>& faces) {
  const Scalar margin = clipping::slab_margin(a, b);
  const auto off_at = [&](const FoundFace<Scalar>& face) {
    const bool is_of_a = face.side == Side::a;
    PlaceOff<Scalar> here = least_off_at_face(is_of_a ? a : b, face.found, is_of_a ? b : a, margin);
    here.off += faces.separation() - face.found.separation;
    return here;
  };
  FoundFace<Scalar> best = faces.greatest();
  PlaceOff<Scalar> least = off_at(best);
  for (const FoundFace<Scalar>& face : std::span(faces.all.data(), faces.count)) {
    const PlaceOff<Scalar> here = off_at(face);
    if (here.off >= least.off) continue;
    least = here;
    best = face;
  }
  return contact_at_face(a, b, best.side, best.found.face, best.found.separation, least.place);
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

/// The greatest separation of all faces, not only of those that GJK has found; minus infinity of a
/// point.
template <class Scalar>
clipping::FaceSeparation<Scalar> greatest_of_all_faces(const ConvexPolygon<Scalar>& polygon,
                                                       const ConvexPolygon<Scalar>& other) {
  if (polygon.face_count() == 0) return {};
  return clipping::greatest_separation(polygon, other, std::numeric_limits<Scalar>::infinity());
}

/// The contact of round shapes for which GJK has found two vertices. Where the line between them
/// is not normal to both, rounding took a vertex far along a face for its deepest, and the nearest
/// places are looked for as clipping does.
template <class Scalar>
Manifold<Scalar> contact_of_vertices(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                                     const NearestFaces<Scalar>& faces,
                                     const clipping::NearestPlaces<Scalar>& vertices,
                                     Scalar roundoff) {
  clipping::FaceSeparation<Scalar> of_a = faces.of_a;
  clipping::FaceSeparation<Scalar> of_b = faces.of_b;
  clipping::NearestPlaces<Scalar> nearest = vertices;
  if (!clipping::are_nearest(a, b, vertices)) {
    of_a = greatest_of_all_faces(a, b);
    of_b = greatest_of_all_faces(b, a);
    nearest = clipping::nearest_places(a, b, of_a, of_b, roundoff);
  }
  const auto normal = clipping::nearest_normal(a, b, of_a, of_b, nearest, roundoff);
  if (!normal) return contact_at_deepest(a, b, faces);
  return clipping::nearest_contact(a, b, nearest, *normal, roundoff, SecondPoint::never());
}

/// Where nothing is in front of a face: at two vertices; of cores that overlap, and of mitred ones
/// whose vertices rounding alone took for the nearest, at the face and place that are least off.
template <class Scalar>
Manifold<Scalar> contact_outside_faces(const ConvexPolygon<Scalar>& a,
                                       const ConvexPolygon<Scalar>& b,
                                       const NearestFeatures<Scalar>& nearest, Scalar roundoff) {
  if (clipping::is_circle(a) && clipping::is_circle(b)) return clipping::contact_of_circles(a, b);
  if (nearest.apartness == Apartness::overlapping) {
    return contact_at_deepest(a, b, nearest.faces);
  }
  if (are_round(a, b)) {
    return contact_of_vertices(a, b, nearest.faces, nearest.vertices, roundoff);
  }
  return clipping::are_nearest(a, b, nearest.vertices)
             ? contact_of_skins(a, b, nearest.faces, nearest.vertices)
             : contact_at_deepest(a, b, nearest.faces);
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
