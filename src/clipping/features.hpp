#pragma once

#include <cmath>
#include <limits>

#include "geometry/convex_polygon.hpp"
#include "geometry/manifold.hpp"

namespace manifuzz::clipping {

/// The two features that touch: a face of one polygon, an edge of the other.
struct ContactFeatures {
  Side reference_side = Side::a;  ///< the polygon whose face clips
  int reference = 0;              ///< the face that clips, of the polygon `reference_side`
  int incident = 0;               ///< the edge that is clipped, of the other polygon
};

/// The vertex farthest along `direction`, of any length and in the polygon's frame; the first of
/// equals.
template <class Scalar>
int farthest_vertex(const ConvexPolygon<Scalar>& polygon, const Vector2<Scalar>& direction) {
  int farthest = 0;
  Scalar greatest = -std::numeric_limits<Scalar>::infinity();
  for (int i = 0; i < polygon.count; ++i) {
    const Scalar projection = direction.dot(polygon.vertices[i]);
    if (projection > greatest) {
      greatest = projection;
      farthest = i;
    }
  }
  return farthest;
}

/// The edge that takes part in the contact along `normal`, which points out of the polygon: of the
/// two edges at the farthest vertex the one more perpendicular to the normal, the previous one of
/// equals. (The article, "Finding the Features"; unit edges, pointing towards the vertex.)
template <class Scalar>
int best_edge(const ConvexPolygon<Scalar>& polygon, const Vector2<Scalar>& normal) {
  const int vertex = farthest_vertex(polygon, normal);
  const int previous = polygon.previous(vertex);
  const Scalar along_previous = counter_clockwise_quarter(polygon.normals[previous]).dot(normal);
  const Scalar along_next = -counter_clockwise_quarter(polygon.normals[vertex]).dot(normal);
  return along_previous <= along_next ? previous : vertex;
}

/// Reference is the best edge more perpendicular to the normal, A's on a tie; the other is
/// incident. Both polygons stand in one frame; the normal is unit and points from A to B. (The
/// article, "Clipping"; with unit edges, since a given normal may be approximate.)
template <class Scalar>
ContactFeatures choose_features(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                                const Vector2<Scalar>& normal) {
  const int edge_a = best_edge<Scalar>(a, normal);
  const int edge_b = best_edge<Scalar>(b, -normal);
  const Scalar tilt_a = std::abs(cross<Scalar>(a.normals[edge_a], normal));
  const Scalar tilt_b = std::abs(cross<Scalar>(b.normals[edge_b], normal));
  if (tilt_a <= tilt_b) return {Side::a, edge_a, edge_b};
  return {Side::b, edge_b, edge_a};
}

/// The edge whose normal is most opposed to the reference face's outward one, the first of equals;
/// both in one frame. Equals are told as exactly as the scalar's dot of two unit normals. It is the
/// best edge of the article, found without the farthest vertex, which picks wrongly on tiny edges.
/// (Box2D: b2FindIncidentEdge.)
template <class Scalar>
int incident_edge(const ConvexPolygon<Scalar>& polygon, const Vector2<Scalar>& reference_normal) {
  int incident = 0;
  Scalar least = std::numeric_limits<Scalar>::infinity();
  for (int i = 0; i < polygon.count; ++i) {
    const Scalar dot = reference_normal.dot(polygon.normals[i]);
    if (dot < least) {
      least = dot;
      incident = i;
    }
  }
  return incident;
}

}  // namespace manifuzz::clipping
