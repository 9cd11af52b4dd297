#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "clipping/clip.hpp"
#include "clipping/separation.hpp"

namespace manifuzz::clipping {

/// The places where the outlines of two cores are nearest: two vertices, or a vertex and the inside
/// of a face. Everything is in the cores' common frame.
template <class Scalar>
struct NearestPlaces {
  Vector2<Scalar> on_a{0, 0};   ///< A's place
  Vector2<Scalar> on_b{0, 0};   ///< B's place
  Vector2<Scalar> apart{0, 0};  ///< from A's place to B's
  FeaturePair features;         ///< A's vertex or face, and B's
};

/// In double: no square of floats over- or underflows there.
template <class Scalar>
double squared_length(const Vector2<Scalar>& v) {
  const Vector2<double>& wide = v.template cast<double>();  // itself, where it is in double
  return wide.dot(wide);
}

/// Vertex i of A and vertex j of B.
template <class Scalar>
NearestPlaces<Scalar> between_vertices(const ConvexPolygon<Scalar>& a, int i,
                                       const ConvexPolygon<Scalar>& b, int j) {
  const Vector2<Scalar>& on_a = a.vertices[i];
  const Vector2<Scalar>& on_b = b.vertices[j];
  return {on_a, on_b, on_b - on_a, {vertex(i), vertex(j)}};
}

/// The nearest vertices of two cores, the first of equals.
template <class Scalar>
NearestPlaces<Scalar> nearest_vertices(const ConvexPolygon<Scalar>& a,
                                       const ConvexPolygon<Scalar>& b) {
  NearestPlaces<Scalar> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < a.count; ++i) {
    for (int j = 0; j < b.count; ++j) {
      const NearestPlaces<Scalar> places = between_vertices(a, i, b, j);
      const double squared = squared_length(places.apart);
      if (squared >= least) continue;
      least = squared;
      nearest = places;
    }
  }
  return nearest;
}

/// From vertex i to vertex i + 1, unit; (0, 0) of a point. By the normal: rounding the ends of a
/// tiny edge far from its own origin turns the edge by far more.
template <class Scalar>
Vector2<Scalar> along_face(const ConvexPolygon<Scalar>& polygon, int i) {
  return counter_clockwise_quarter(polygon.normals[i]);
}

/// The vertex, or a neighbour of it that is nearer to a place: one past which the place is along
/// the face between. Told by the sums of `is_before_face`, so that rounding leaves no place that is
/// neither before a face nor at a vertex.
template <class Scalar>
int nearer_vertex(const ConvexPolygon<Scalar>& polygon, int at, const Vector2<Scalar>& place) {
  const auto is_past = [&](int neighbour, const Vector2<Scalar>& along) {
    return along.dot(place - polygon.vertices[at]) > 0 &&
           along.dot(polygon.vertices[neighbour] - place) <= 0;
  };
  const int previous = polygon.previous(at);
  if (is_past(previous, -along_face(polygon, previous))) return previous;
  const int next = polygon.next(at);
  return is_past(next, along_face(polygon, at)) ? next : at;
}

/// The vertices at which a walk from vertex i of A and j of B ends, each step to neighbours that
/// are nearer. Faces tell which are, better than squares of distances, rounded: beside tiny edges.
template <class Scalar>
NearestPlaces<Scalar> walk_nearer(const ConvexPolygon<Scalar>& a, int i,
                                  const ConvexPolygon<Scalar>& b, int j) {
  NearestPlaces<Scalar> places = between_vertices(a, i, b, j);
  for (int steps = 0; steps < a.count + b.count; ++steps) {
    const int nearer_i = nearer_vertex(a, i, places.on_b);
    const int nearer_j = nearer_vertex(b, j, places.on_a);
    if (nearer_i == i && nearer_j == j) break;
    i = nearer_i;
    j = nearer_j;
    places = between_vertices(a, i, b, j);
  }
  return places;
}

/// Whether a direction is among a vertex's outward normals: no neighbour is farther along it. Told
/// relative to the direction's length, however short.
template <class Scalar>
bool is_normal_at(const ConvexPolygon<Scalar>& polygon, int corner,
                  const Vector2<Scalar>& direction) {
  return direction.dot(along_face(polygon, corner)) <= 0 &&
         direction.dot(along_face(polygon, polygon.previous(corner))) >= 0;
}

/// Whether one of a vertex's edges faces along a direction, of any length, or is perpendicular to
/// it but for how normals are rounded. None does of a vertex that only rounding puts on the side
/// that is near: the shape is thinner there, or the corner is flat and the direction points
/// inwards.
template <class Scalar>
bool has_edge_along(const ConvexPolygon<Scalar>& polygon, int corner,
                    const Vector2<Scalar>& direction) {
  const Scalar least = -4 * std::numeric_limits<Scalar>::epsilon() * direction.template lpNorm<1>();
  return polygon.normals[corner].dot(direction) >= least ||
         polygon.normals[polygon.previous(corner)].dot(direction) >= least;
}

/// Whether the line between two vertices is normal to both shapes, so that no others are nearer.
template <class Scalar>
bool are_nearest(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                 const NearestPlaces<Scalar>& places) {
  const int i = places.features.a.index;
  const int j = places.features.b.index;
  return is_normal_at<Scalar>(a, i, places.apart) && is_normal_at<Scalar>(b, j, -places.apart) &&
         has_edge_along<Scalar>(a, i, places.apart) && has_edge_along<Scalar>(b, j, -places.apart);
}

/// Whether a point lies between the ends of a face, seen along the face's normal.
template <class Scalar>
bool is_before_face(const ConvexPolygon<Scalar>& polygon, int face_index,
                    const Vector2<Scalar>& point) {
  const Vector2<Scalar> along = along_face(polygon, face_index);
  return along.dot(point - polygon.vertices[face_index]) > 0 &&
         along.dot(polygon.vertices[polygon.next(face_index)] - point) > 0;
}

/// A vertex of polygon `side`'s opposing one in front of the inside of its face: the foot there,
/// and the vertex.
template <class Scalar>
NearestPlaces<Scalar> before_face(const ConvexPolygon<Scalar>& polygon, Side side, int face_index,
                                  const Vector2<Scalar>& corner, int corner_index) {
  const Vector2<Scalar>& normal = polygon.normals[face_index];
  const Vector2<Scalar> out = normal.dot(corner - polygon.vertices[face_index]) * normal;
  const Vector2<Scalar> foot = corner - out;
  const Feature of_face = face(face_index);
  if (side == Side::a) return {foot, corner, out, {of_face, vertex(corner_index)}};
  return {corner, foot, -out, {vertex(corner_index), of_face}};
}

/// A vertex of `opposing` that lies in front of the inside of a face of polygon `side`, as near to
/// it as any but for `roundoff`, a length; nothing where there is none.
template <class Scalar>
std::optional<NearestPlaces<Scalar>> places_at_face(const ConvexPolygon<Scalar>& polygon, Side side,
                                                    const FaceSeparation<Scalar>& found,
                                                    const ConvexPolygon<Scalar>& opposing,
                                                    Scalar roundoff) {
  const Vector2<Scalar>& normal = polygon.normals[found.face];
  for (int j = 0; j < opposing.count; ++j) {
    const Vector2<Scalar>& corner = opposing.vertices[j];
    const Scalar separation = normal.dot(corner - polygon.vertices[found.face]);
    if (separation > found.separation + roundoff) continue;
    if (!is_before_face(polygon, found.face, corner)) continue;
    if (!has_edge_along<Scalar>(opposing, j, -normal)) continue;
    return before_face<Scalar>(polygon, side, found.face, corner, j);
  }
  return std::nullopt;
}

/// The face of greatest separation, of those that separate by `least` or more, a length, that has
/// its nearest vertex in front of it. Beside corners that are nearly flat rounding may call another
/// face the farthest, which has none.
template <class Scalar>
std::optional<NearestPlaces<Scalar>> places_at_any_face(const ConvexPolygon<Scalar>& a,
                                                        const ConvexPolygon<Scalar>& b,
                                                        Scalar least, Scalar roundoff) {
  std::optional<NearestPlaces<Scalar>> nearest;
  for_each_face(a, b, [&](Side side, const auto& polygon, int face_index, const auto& opposing) {
    const FaceSeparation<Scalar> found = face_separation(polygon, face_index, opposing);
    if (least > found.separation) return;
    const auto places = places_at_face(polygon, side, found, opposing, roundoff);
    if (!places) return;
    least = found.separation;
    nearest = places;
  });
  return nearest;
}

/// Calls `visit(places, separation)` for each corner of `opposing` before a face of polygon `side`:
/// the foot there and the corner, and how far the corner is in front, a length, negative behind it.
template <class Scalar, class Visit>
void for_each_before_face(const ConvexPolygon<Scalar>& polygon, Side side, int face_index,
                          const ConvexPolygon<Scalar>& opposing, const Visit& visit) {
  for (int j = 0; j < opposing.count; ++j) {
    const Vector2<Scalar>& corner = opposing.vertices[j];
    if (!is_before_face(polygon, face_index, corner)) continue;
    visit(before_face<Scalar>(polygon, side, face_index, corner, j),
          polygon.normals[face_index].dot(corner - polygon.vertices[face_index]));
  }
}

/// How far the line between two vertices leads along an edge of either, and no farther than the
/// edge: about as far as nearer places are from them, a length. 0 where it is normal to both.
template <class Scalar>
Scalar slip_along_edges(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                        const NearestPlaces<Scalar>& places) {
  const auto slip = [](const ConvexPolygon<Scalar>& polygon, int corner,
                       const Vector2<Scalar>& outward) {
    const auto along = [&](int edge, int neighbour, Scalar sign) {
      const Vector2<Scalar> to_neighbour = sign * along_face(polygon, edge);
      const Vector2<Scalar> whole = polygon.vertices[neighbour] - polygon.vertices[corner];
      return std::min(to_neighbour.dot(outward), to_neighbour.dot(whole));
    };
    const int previous = polygon.previous(corner);
    return std::max(along(corner, polygon.next(corner), Scalar(1)),
                    along(previous, previous, Scalar(-1)));
  };
  return std::max({slip(a, places.features.a.index, places.apart),
                   slip(b, places.features.b.index, -places.apart), Scalar(0)});
}

/// The vertices at which a walk from the nearest ones ends, unless they are farther from each other
/// by more than `roundoff`, a length. Faces tell which are nearest where rounded distances do not.
template <class Scalar>
NearestPlaces<Scalar> nearest_vertices_by_faces(const ConvexPolygon<Scalar>& a,
                                                const ConvexPolygon<Scalar>& b, Scalar roundoff) {
  const NearestPlaces<Scalar> nearest = nearest_vertices(a, b);
  const NearestPlaces<Scalar> walked =
      walk_nearer(a, nearest.features.a.index, b, nearest.features.b.index);
  const double farther =
      std::sqrt(squared_length(walked.apart)) - std::sqrt(squared_length(nearest.apart));
  return farther <= static_cast<double>(roundoff) ? walked : nearest;
}

/// Where two cores are nearest that are apart by more than rounding: at the nearest vertices, or
/// at the nearest corner before a face unless it is farther away by more than these are off, or
/// than `roundoff`, a length. No face is asked for its deepest vertex, since rounding, of placing
/// the cores too, may take another for it. A face is passed over where the other core lies behind
/// it by more than `roundoff`: it is on the far side, and rounding has put a corner before it.
template <class Scalar>
NearestPlaces<Scalar> nearest_of_all(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                                     Scalar roundoff) {
  NearestPlaces<Scalar> nearest = nearest_vertices_by_faces(a, b, roundoff);
  const Scalar off = std::min(slip_along_edges(a, b, nearest), roundoff);
  double least = std::sqrt(squared_length(nearest.apart)) + static_cast<double>(off);
  const auto take_nearer = [&](const NearestPlaces<Scalar>& places, Scalar separation) {
    const auto wide = static_cast<double>(separation);
    if (wide <= 0 || wide >= least) return;
    least = wide;
    nearest = places;
  };
  for_each_face(a, b, [&](Side side, const auto& polygon, int face_index, const auto& opposing) {
    if (face_separation(polygon, face_index, opposing).separation < -roundoff) return;
    for_each_before_face(polygon, side, face_index, opposing, take_nearer);
  });
  return nearest;
}

/// The most by which a face's far end is off the face's line, a length: vertices and normals are
/// rounded apart when a polygon is placed, the more so from far away.
template <class Scalar>
Scalar misfit_of_faces(const ConvexPolygon<Scalar>& placed) {
  Scalar most = 0;
  for (int i = 0; i < placed.face_count(); ++i) {
    const Vector2<Scalar> whole = placed.vertices[placed.next(i)] - placed.vertices[i];
    most = std::max(most, std::abs(placed.normals[i].dot(whole)));
  }
  return most;
}

/// Where two cores are nearest that do not overlap by more than `roundoff`, a length. A face with
/// its deepest vertex in front of it is nearest to that; only those of greatest separation, A's
/// and B's, may have it. Else two vertices are nearest. Where rounding hides which, all faces and
/// vertices are looked at.
template <class Scalar>
NearestPlaces<Scalar> nearest_places(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                                     const FaceSeparation<Scalar>& of_a,
                                     const FaceSeparation<Scalar>& of_b, Scalar roundoff) {
  const bool a_first = of_a.separation >= of_b.separation;
  const Scalar least = std::min(std::max(of_a.separation, of_b.separation), Scalar(0)) - roundoff;
  for (const Side side : {a_first ? Side::a : Side::b, a_first ? Side::b : Side::a}) {
    const FaceSeparation<Scalar>& found = side == Side::a ? of_a : of_b;
    const ConvexPolygon<Scalar>& polygon = side == Side::a ? a : b;
    const ConvexPolygon<Scalar>& opposing = side == Side::a ? b : a;
    if (found.separation < least) continue;
    const auto places = places_at_face(polygon, side, found, opposing, roundoff);
    if (places) return *places;
  }
  const NearestPlaces<Scalar> places = a_first ? walk_nearer(a, of_a.face, b, of_a.deepest)
                                               : walk_nearer(a, of_b.deepest, b, of_b.face);
  if (are_nearest(a, b, places)) return places;
  // By so much a face's separation depends on the end that it is measured from.
  const Scalar misfit = misfit_of_faces(a) + misfit_of_faces(b);
  const auto at_face = places_at_any_face<Scalar>(a, b, least - misfit, roundoff);
  if (at_face) return *at_face;
  // A corner on the other core's outline, or inside, is before faces of its far side as well.
  const bool are_apart = std::max(of_a.separation, of_b.separation) > roundoff;
  return are_apart ? nearest_of_all(a, b, roundoff + misfit) : nearest_vertices(a, b);
}

}  // namespace manifuzz::clipping
