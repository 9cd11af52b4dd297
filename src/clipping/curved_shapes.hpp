#pragma once

#include <algorithm>
#include <limits>
#include <optional>

#include "clipping/deepest_contact.hpp"
#include "clipping/nearest.hpp"

// The article's "Curved Shapes": circles, capsules, segments and polygons with round corners. Their
// features are a point or an edge; a point on either side is the manifold, two edges are clipped.

namespace manifuzz::clipping {

/// Whether a vertex of the opposing core is inside of a polygon, behind each of its faces by more
/// than `roundoff`, a length.
template <class Scalar>
bool has_vertex_inside(const ConvexPolygon<Scalar>& polygon, const ConvexPolygon<Scalar>& opposing,
                       Scalar roundoff) {
  const auto is_inside = [&](const Vector2<Scalar>& point) {
    for (int i = 0; i < polygon.count; ++i) {
      if (polygon.normals[i].dot(point - polygon.vertices[i]) >= -roundoff) return false;
    }
    return true;
  };
  return polygon.count >= kMinVertices && std::ranges::any_of(opposing.corners(), is_inside);
}

/// The square of how near the outlines of two cores are, whether these overlap or not.
template <class Scalar>
double squared_between_outlines(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b) {
  double least = squared_length(nearest_vertices(a, b).apart);
  for_each_face(a, b, [&](Side side, const auto& polygon, int face_index, const auto& opposing) {
    for_each_before_face(polygon, side, face_index, opposing,
                         [&](const NearestPlaces<Scalar>&, Scalar separation) {
                           const auto wide = static_cast<double>(separation);
                           least = std::min(least, wide * wide);
                         });
  });
  return least;
}

/// Whether cores overlap by more than rounding, so that faces decide. Where one holds a vertex of
/// the other they do, however rounding moved the face that separates most. What overlaps has its
/// outlines at least as near as the overlap is deep: segments on one line, end to end, do not,
/// though no face separates them.
template <class Scalar>
bool do_cores_overlap(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                      const FaceSeparation<Scalar>& of_a, const FaceSeparation<Scalar>& of_b,
                      Scalar roundoff) {
  const bool by_a = of_a.separation >= of_b.separation;
  const FaceSeparation<Scalar>& found = by_a ? of_a : of_b;
  if (found.separation >= -roundoff) return false;
  const ConvexPolygon<Scalar>& polygon = by_a ? a : b;
  const ConvexPolygon<Scalar>& opposing = by_a ? b : a;
  if (is_before_face(polygon, found.face, opposing.vertices[found.deepest])) return true;
  if (has_vertex_inside(a, b, roundoff) || has_vertex_inside(b, a, roundoff)) return true;
  return std::sqrt(squared_between_outlines(a, b)) <=
         static_cast<double>(roundoff - found.separation);
}

/// The unit direction of a difference of two places, rounded once; none of one so short that it may
/// be subnormal, or is 0.
template <class Scalar>
std::optional<Vector2<Scalar>> direction_between(const Vector2<Scalar>& apart) {
  constexpr double shortest = static_cast<double>(std::numeric_limits<Scalar>::min() /
                                                  std::numeric_limits<Scalar>::epsilon());
  const double length = std::sqrt(squared_length(apart));
  if (length < shortest) return std::nullopt;
  const Vector2<double> unit = apart.template cast<double>() / length;
  return Vector2<Scalar>(unit.template cast<Scalar>());
}

/// The unit normal from A to B on which the places are nearest: a face's own, or from vertex to
/// vertex where that is among the normals of both; where rounding hides whether it is, that of the
/// face which separates most, if it is along that too. None where cores are so near that edges may
/// cross, and rounding hides where.
template <class Scalar>
std::optional<Vector2<Scalar>> nearest_normal(const ConvexPolygon<Scalar>& a,
                                              const ConvexPolygon<Scalar>& b,
                                              const FaceSeparation<Scalar>& of_a,
                                              const FaceSeparation<Scalar>& of_b,
                                              const NearestPlaces<Scalar>& nearest,
                                              Scalar roundoff) {
  const auto& [place_a, place_b] = nearest.features;
  if (place_a.kind == Feature::Kind::face) return a.normals[place_a.index];
  if (place_b.kind == Feature::Kind::face) return Vector2<Scalar>(-b.normals[place_b.index]);
  const auto direction = direction_between(nearest.apart);
  if (direction && are_nearest(a, b, nearest)) return direction;
  const bool is_of_a = of_a.separation >= of_b.separation;
  const Vector2<Scalar> normal =
      is_of_a ? a.normals[of_a.face] : Vector2<Scalar>(-b.normals[of_b.face]);
  // Rounding turns a short line out of its vertices' normals, but its ends by no more than this.
  const Scalar reach = 2 * roundoff;
  if (std::abs(normal.dot(clockwise_quarter(nearest.apart))) <= reach) return normal;
  const double wide = static_cast<double>(reach);
  const bool are_apart = std::max(of_a.separation, of_b.separation) >= -roundoff &&
                         squared_length(nearest.apart) > wide * wide;
  return are_apart ? direction : std::nullopt;
}

/// The edge that a shape gives at its nearest place: the face itself, or of the two edges at the
/// vertex the one more perpendicular to `outward`, which is unit; none where its
/// normal is further from `outward` than a second point may have it.
template <class Scalar>
std::optional<int> edge_at(const ConvexPolygon<Scalar>& polygon, Feature place,
                           const Vector2<Scalar>& outward, SecondPoint second_point) {
  int edge = place.index;
  if (place.kind == Feature::Kind::vertex) {
    const int previous = polygon.previous(edge);
    if (polygon.normals[previous].dot(outward) > polygon.normals[edge].dot(outward)) {
      edge = previous;
    }
  }
  const auto least = static_cast<Scalar>(second_point.least_cosine);
  if (polygon.normals[edge].dot(outward) < least) return std::nullopt;
  return edge;
}

/// Adds the other end of what the clip of two edges keeps: between the planes through the reference
/// edge's ends, perpendicular to `along`, and no farther from the reference edge than the total
/// radius, all measured along `outward`, which points out of the reference.
template <class Scalar>
void add_second_point(const ConvexPolygon<Scalar>& reference, int reference_edge,
                      const ConvexPolygon<Scalar>& incident, int incident_edge,
                      const Vector2<Scalar>& on_reference, const Vector2<Scalar>& on_incident,
                      const Vector2<Scalar>& outward, Scalar roundoff, Manifold<Scalar>& manifold) {
  const Vector2<Scalar> along = counter_clockwise_quarter(outward);
  const Vector2<Scalar> whole =
      reference.vertices[reference.next(reference_edge)] - reference.vertices[reference_edge];
  const Scalar run = along.dot(whole);
  ClipEdge<Scalar> edge = whole_edge(incident, incident_edge, reference_edge);
  if (run <= roundoff ||
      !clip_to_slab<Scalar>(edge, reference, reference_edge, along, Scalar(0), incident_edge)) {
    return;
  }
  const auto distance = [&](const ClipEnd<Scalar>& end) {
    return std::abs(along.dot(end.position - on_incident));
  };
  const ClipEnd<Scalar>& end = distance(edge[1]) > distance(edge[0]) ? edge[1] : edge[0];
  if (distance(end) <= roundoff) return;
  // A crossing is in front of the reference edge's end, whose height no slope has to tell.
  const bool is_crossing = end.reference.kind == Feature::Kind::vertex;
  const Vector2<Scalar>& level =
      is_crossing ? reference.vertices[end.reference.index] : on_reference;
  const Scalar slope = is_crossing ? Scalar(0) : outward.dot(whole) / run;
  const Vector2<Scalar> from_level = end.position - level;
  const Scalar separation = outward.dot(from_level) - slope * along.dot(from_level);
  const Scalar total_radius = reference.radius + incident.radius;
  if (separation > total_radius) return;
  FeaturePair features{end.reference, end.incident};
  if (manifold.reference == Side::b) std::swap(features.a, features.b);
  manifold.points[manifold.count++] = {end.position, total_radius - separation, features};
}

/// Puts the points on the incident shape's surface: a radius from its core, against the normal that
/// points out of the reference.
template <class Scalar>
void put_on_surface(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                    Manifold<Scalar>& manifold) {
  const Scalar towards_b = manifold.reference == Side::a ? -b.radius : a.radius;
  for (int i = 0; i < manifold.count; ++i) {
    manifold.points[i].position += towards_b * manifold.normal;
  }
}

/// The manifold of round shapes from where their cores are nearest, and the normal there. The
/// deepest point is that place; the second one, if both give an edge, the other end of their clip.
template <class Scalar>
Manifold<Scalar> nearest_contact(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                                 const NearestPlaces<Scalar>& nearest,
                                 const Vector2<Scalar>& normal, Scalar roundoff,
                                 SecondPoint second_point) {
  const Scalar total_radius = a.radius + b.radius;
  const Scalar separation = normal.dot(nearest.apart);
  if (separation > total_radius) return {};

  const auto edge_a = edge_at<Scalar>(a, nearest.features.a, normal, second_point);
  const auto edge_b = edge_at<Scalar>(b, nearest.features.b, -normal, second_point);
  Manifold<Scalar> manifold;
  manifold.count = 1;
  manifold.normal = normal;
  manifold.reference = edge_a ? Side::a : Side::b;  // an end is incident, A's before B's
  if (edge_a && edge_b) {
    const bool b_is_flatter = -b.normals[*edge_b].dot(normal) > a.normals[*edge_a].dot(normal);
    if (b_is_flatter) manifold.reference = Side::b;
  }
  const bool from_a = manifold.reference == Side::a;
  manifold.points[0] = {from_a ? nearest.on_b : nearest.on_a, total_radius - separation,
                        nearest.features};
  if (edge_a && edge_b) {
    if (from_a) {
      add_second_point<Scalar>(a, *edge_a, b, *edge_b, nearest.on_a, nearest.on_b, normal, roundoff,
                               manifold);
    } else {
      add_second_point<Scalar>(b, *edge_b, a, *edge_a, nearest.on_b, nearest.on_a, -normal,
                               roundoff, manifold);
    }
  }
  put_on_surface(a, b, manifold);
  order_points(manifold);
  return manifold;
}

/// Gives a manifold of overlapping cores its deepest vertex where rounding has cut a steep edge
/// just before it: of round shapes the overlap itself must be there. `greatest` is the separation.
template <class Scalar>
void restore_deepest_vertex(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                            Scalar greatest, Manifold<Scalar>& manifold) {
  const Side side = manifold.reference;
  const ConvexPolygon<Scalar>& reference = side == Side::a ? a : b;
  const ConvexPolygon<Scalar>& opposing = side == Side::a ? b : a;
  const Vector2<Scalar> outward =
      side == Side::a ? manifold.normal : Vector2<Scalar>(-manifold.normal);
  for (int i = 0; i < reference.face_count(); ++i) {
    if (reference.normals[i] != outward) continue;
    const FaceSeparation<Scalar> found = face_separation(reference, i, opposing);
    if (!misses_deepest(a, b, manifold, found.separation, greatest)) continue;
    const Vector2<Scalar>& deepest = opposing.vertices[found.deepest];
    if (!slab_holds<Scalar>(reference, i, deepest, separation_roundoff(a, b))) continue;
    const bool is_second =
        manifold.count > 1 && manifold.points[1].depth > manifold.points[0].depth;
    manifold.points[is_second ? 1 : 0] = lone_vertex(reference, side, found, opposing).points[0];
    return;
  }
}

/// The manifold of round shapes whose cores overlap, from what the clip by a face kept: of a point,
/// and of an edge that a second point may not have, the deepest alone.
template <class Scalar>
Manifold<Scalar> overlapping_contact(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                                     const Manifold<Scalar>& clipped, SecondPoint second_point) {
  Manifold<Scalar> manifold = clipped;
  const bool from_a = manifold.reference == Side::a;
  const ConvexPolygon<Scalar>& incident = from_a ? b : a;
  const Vector2<Scalar> towards = from_a ? Vector2<Scalar>(-manifold.normal) : manifold.normal;
  if (manifold.count == 2) {
    const int edge = incident_edge<Scalar>(incident, -towards);
    const bool is_edge =
        incident.normals[edge].dot(towards) >= static_cast<Scalar>(second_point.least_cosine);
    if (!is_edge) {
      if (manifold.points[1].depth > manifold.points[0].depth) {
        manifold.points[0] = manifold.points[1];
      }
      manifold.count = 1;
    }
  }
  put_on_surface(a, b, manifold);
  return manifold;
}

}  // namespace manifuzz::clipping
