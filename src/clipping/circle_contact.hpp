#pragma once

#include <limits>
#include <optional>

#include "clipping/curved_shapes.hpp"

// The article's "Curved Shapes", of a circle: its feature is one point, and the manifold is that
// point. A circle has no faces to search, and what it touches nothing to clip.

namespace manifuzz::clipping {

/// Whether the shape is a circle, whose core is one point.
template <class Scalar>
bool is_circle(const ConvexPolygon<Scalar>& shape) {
  return shape.count == 1;
}

/// The manifold of one point, where cores are nearest: on the incident shape's surface. Empty where
/// the places are farther apart along the normal, unit and from A to B, than the radii reach.
template <class Scalar>
Manifold<Scalar> one_point(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                           const NearestPlaces<Scalar>& nearest, const Vector2<Scalar>& normal,
                           Side reference) {
  Manifold<Scalar> manifold;
  const Scalar total_radius = a.radius + b.radius;
  const Scalar separation = normal.dot(nearest.apart);
  if (separation <= total_radius) {
    const bool from_a = reference == Side::a;
    const Vector2<Scalar>& on_core = from_a ? nearest.on_b : nearest.on_a;
    const Scalar towards_b = from_a ? -b.radius : a.radius;
    manifold.count = 1;
    manifold.reference = reference;
    manifold.normal = normal;
    manifold.points[0].position = on_core + towards_b * normal;
    manifold.points[0].depth = total_radius - separation;
    manifold.points[0].features = nearest.features;
  }
  return manifold;
}

/// Whether two places are farther apart than `reach`, a length, by more than what rounding does to
/// the separation along their direction: less than 4 eps of it. Known before the root is.
template <class Scalar>
bool are_beyond(const Vector2<Scalar>& apart, Scalar reach) {
  constexpr double widened = 1 + 8 * static_cast<double>(std::numeric_limits<Scalar>::epsilon());
  const auto wide = static_cast<double>(reach);
  return squared_length(apart) > wide * wide * widened;
}

/// The manifold of two circles. Centres so near that their difference may be subnormal have any
/// normal, (1, 0).
template <class Scalar>
Manifold<Scalar> contact_of_circles(const ConvexPolygon<Scalar>& a,
                                    const ConvexPolygon<Scalar>& b) {
  const Vector2<Scalar> apart = b.vertices[0] - a.vertices[0];
  if (are_beyond<Scalar>(apart, a.radius + b.radius)) return {};
  const auto normal = direction_between(apart);
  return one_point<Scalar>(a, b, {a.vertices[0], b.vertices[0], apart, {vertex(0), vertex(0)}},
                           normal ? *normal : Vector2<Scalar>(1, 0), Side::b);
}

/// The face of greatest separation from a point, the first of equals.
template <class Scalar>
FaceSeparation<Scalar> greatest_separation_from(const ConvexPolygon<Scalar>& core,
                                                const Vector2<Scalar>& point) {
  FaceSeparation<Scalar> greatest;
  for (int i = 0; i < core.count; ++i) {
    const Scalar separation = core.normals[i].dot(point - core.vertices[i]);
    if (separation > greatest.separation) {
      greatest.face = i;
      greatest.separation = separation;
    }
  }
  return greatest;
}

/// Whether a point that is past an end of a face is past the second one.
template <class Scalar>
bool is_past_second_end(const ConvexPolygon<Scalar>& core, int face_index,
                        const Vector2<Scalar>& point) {
  return along_face(core, face_index).dot(point - core.vertices[face_index]) > 0;
}

/// The vertex at which a walk ends from the end of a face that a point is past, each step to a
/// neighbour that is nearer; the face itself has none where the point is before it. Where corners
/// are nearly flat rounding may call a face the farthest that the point is far past.
template <class Scalar>
std::optional<int> end_of_walk(const ConvexPolygon<Scalar>& core, int face_index,
                               const Vector2<Scalar>& point) {
  if (is_before_face(core, face_index, point)) return std::nullopt;
  int end = is_past_second_end(core, face_index, point) ? core.next(face_index) : face_index;
  for (int steps = 0; steps < core.count; ++steps) {
    const int nearer = nearer_vertex(core, end, point);
    if (nearer == end) break;
    end = nearer;
  }
  return end;
}

/// Whether a point is nearest to a vertex from outside: from there it lies among the vertex's
/// normals. Behind the face of greatest separation it is inside where the corner is nearly flat,
/// and past the tip of a needle else.
template <class Scalar>
bool is_outside_at(const ConvexPolygon<Scalar>& core, int corner, int greatest_face,
                   const Vector2<Scalar>& point) {
  const Vector2<Scalar> apart = point - core.vertices[corner];
  if (!is_normal_at<Scalar>(core, corner, apart)) return false;
  const Scalar past = std::abs(along_face(core, greatest_face).dot(apart));
  return core.face_count() < kMinVertices || past + core.normals[greatest_face].dot(apart) > 0;
}

/// The face of greatest separation from a point outside or, where that is past an end of it and
/// before a face beside the `end` of its walk, that one: only rounding called the other farther. A
/// face that the point lies behind has its end there too where a corner is sharp, and is none.
template <class Scalar>
FaceSeparation<Scalar> face_before(const ConvexPolygon<Scalar>& core,
                                   const FaceSeparation<Scalar>& greatest, std::optional<int> end,
                                   const Vector2<Scalar>& point) {
  if (greatest.separation <= 0 || !end) return greatest;
  for (const int beside : {*end, core.previous(*end)}) {
    const Scalar separation = core.normals[beside].dot(point - core.vertices[beside]);
    if (separation > 0 && is_before_face(core, beside, point)) return {beside, separation};
  }
  return greatest;
}

/// The manifold of a circle and of a core with faces, which is polygon `side`: the centre is
/// nearest to the face of greatest separation, inside the core or out, or to an end of it.
template <class Scalar>
Manifold<Scalar> contact_of_circle(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                                   Side side, SecondPoint second_point) {
  const bool is_of_a = side == Side::a;
  const ConvexPolygon<Scalar>& core = is_of_a ? a : b;
  const Vector2<Scalar>& centre = is_of_a ? b.vertices[0] : a.vertices[0];
  const FaceSeparation<Scalar> found = greatest_separation_from(core, centre);
  if (found.separation > a.radius + b.radius) return {};

  const auto contact = [&](const Vector2<Scalar>& on_core, Feature place,
                           const Vector2<Scalar>& apart, const Vector2<Scalar>& outward) {
    if (!is_of_a) {
      return one_point<Scalar>(a, b, {centre, on_core, -apart, {vertex(0), place}}, -outward,
                               Side::b);
    }
    const bool has_edge = edge_at(a, place, outward, second_point).has_value();
    return one_point<Scalar>(a, b, {on_core, centre, apart, {place, vertex(0)}}, outward,
                             has_edge ? Side::a : Side::b);
  };
  const std::optional<int> end = end_of_walk(core, found.face, centre);
  if (end && is_outside_at<Scalar>(core, *end, found.face, centre)) {
    const Vector2<Scalar> apart = centre - core.vertices[*end];
    if (are_beyond<Scalar>(apart, a.radius + b.radius)) return {};
    if (const auto outward = direction_between(apart)) {
      return contact(core.vertices[*end], vertex(*end), apart, *outward);
    }
  }
  const FaceSeparation<Scalar> before = face_before(core, found, end, centre);
  const Vector2<Scalar>& normal = core.normals[before.face];
  const Vector2<Scalar> apart = before.separation * normal;
  return contact(centre - apart, face(before.face), apart, normal);
}

}  // namespace manifuzz::clipping
