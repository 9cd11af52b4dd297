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
  Vector2<Scalar> on_a{0, 0};                                ///< A's place
  Vector2<Scalar> on_b{0, 0};                                ///< B's place
  Vector2<Scalar> apart{0, 0};                               ///< from A's place to B's
  FeaturePair features;                                      ///< A's vertex or face, and B's
  double squared = std::numeric_limits<double>::infinity();  ///< of the distance, or just below it
};

/// In double: no square of floats over- or underflows there.
template <class Scalar>
double squared_length(const Vector2<Scalar>& v) {
  const Vector2<double>& wide = v.template cast<double>();  // itself, where it is in double
  return wide.dot(wide);
}

/// The nearest vertices of two cores, the first of equals.
template <class Scalar>
NearestPlaces<Scalar> nearest_vertices(const ConvexPolygon<Scalar>& a,
                                       const ConvexPolygon<Scalar>& b) {
  NearestPlaces<Scalar> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < a.count; ++i) {
    for (int j = 0; j < b.count; ++j) {
      const Vector2<Scalar> apart = b.vertices[j] - a.vertices[i];
      const double squared = squared_length(apart);
      if (squared >= least) continue;
      least = squared;
      nearest = {a.vertices[i], b.vertices[j], apart, {vertex(i), vertex(j)}};
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

/// The vertex, or a neighbour of it that is nearer to a place `towards` it: one past its face.
template <class Scalar>
int nearer_vertex(const ConvexPolygon<Scalar>& polygon, int at, const Vector2<Scalar>& towards) {
  const auto is_past = [&](int neighbour, const Vector2<Scalar>& along) {
    const Scalar past = along.dot(towards);
    return past > 0 && past >= along.dot(polygon.vertices[neighbour] - polygon.vertices[at]);
  };
  const int previous = polygon.previous(at);
  if (is_past(previous, -along_face(polygon, previous))) return previous;
  const int next = polygon.next(at);
  return is_past(next, along_face(polygon, at)) ? next : at;
}

/// Steps from the nearest vertices to neighbours that are nearer, which faces tell better than
/// squares of distances, rounded: beside tiny edges.
template <class Scalar>
void settle_vertices(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                     NearestPlaces<Scalar>& nearest) {
  for (int steps = 0; steps < a.count + b.count; ++steps) {
    const int i = nearer_vertex<Scalar>(a, nearest.features.a.index, nearest.apart);
    const int j = nearer_vertex<Scalar>(b, nearest.features.b.index, -nearest.apart);
    if (i == nearest.features.a.index && j == nearest.features.b.index) return;
    const Vector2<Scalar> apart = b.vertices[j] - a.vertices[i];
    nearest = {a.vertices[i], b.vertices[j], apart, {vertex(i), vertex(j)}};
  }
}

/// A vertex of `opposing` that lies in front of the inside of a face of polygon `side`, as near to
/// it as any but for `roundoff`, a length; nothing where there is none.
template <class Scalar>
std::optional<NearestPlaces<Scalar>> places_at_face(const ConvexPolygon<Scalar>& polygon, Side side,
                                                    const FaceSeparation<Scalar>& found,
                                                    const ConvexPolygon<Scalar>& opposing,
                                                    Scalar roundoff) {
  const Vector2<Scalar>& normal = polygon.normals[found.face];
  const Vector2<Scalar>& from = polygon.vertices[found.face];
  const Vector2<Scalar>& to = polygon.vertices[polygon.next(found.face)];
  const Vector2<Scalar> along = counter_clockwise_quarter(normal);
  for (int j = 0; j < opposing.count; ++j) {
    const Vector2<Scalar>& corner = opposing.vertices[j];
    const Scalar separation = normal.dot(corner - from);
    if (separation > found.separation + roundoff) continue;
    if (along.dot(corner - from) <= 0 || along.dot(to - corner) <= 0) continue;
    const Vector2<Scalar> out = separation * normal;
    const Vector2<Scalar> foot = corner - out;
    const Feature of_face = face(found.face);
    if (side == Side::a) return NearestPlaces<Scalar>{foot, corner, out, {of_face, vertex(j)}};
    return NearestPlaces<Scalar>{corner, foot, -out, {vertex(j), of_face}};
  }
  return std::nullopt;
}

/// Where two cores are nearest that do not overlap by more than `roundoff`, a length. A face with
/// its deepest vertex in front of it is nearest to that; only those of greatest separation, A's
/// and B's, may have it. Else two vertices are nearest.
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
    if (polygon.face_count() == 0 || found.separation < least) continue;
    const auto places = places_at_face(polygon, side, found, opposing, roundoff);
    if (places) return *places;
  }
  NearestPlaces<Scalar> nearest = nearest_vertices(a, b);
  settle_vertices(a, b, nearest);
  return nearest;
}

/// The square of how near the outlines of two cores are, whether these overlap or not.
template <class Scalar>
double squared_between_outlines(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b) {
  double least = squared_length(nearest_vertices(a, b).apart);
  const auto look = [&](const ConvexPolygon<Scalar>& polygon,
                        const ConvexPolygon<Scalar>& opposing) {
    for (int i = 0; i < polygon.face_count(); ++i) {
      const Vector2<Scalar>& normal = polygon.normals[i];
      const Vector2<Scalar> along = counter_clockwise_quarter(normal);
      for (const Vector2<Scalar>& corner : opposing.corners()) {
        const Vector2<Scalar> from = corner - polygon.vertices[i];
        const Vector2<Scalar> to = polygon.vertices[polygon.next(i)] - corner;
        if (along.dot(from) <= 0 || along.dot(to) <= 0) continue;
        const auto separation = static_cast<double>(normal.dot(from));
        least = std::min(least, separation * separation);
      }
    }
  };
  look(a, b);
  look(b, a);
  return least;
}

}  // namespace manifuzz::clipping
