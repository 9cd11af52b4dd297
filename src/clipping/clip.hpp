#pragma once

#include <array>

#include "clipping/features.hpp"

namespace manifuzz::clipping {

/// An end of the incident edge, as far as it has been clipped, and the features that make it.
template <class Scalar>
struct ClipEnd {
  Vector2<Scalar> position{0, 0};  ///< in the polygons' common frame
  Feature reference;               ///< of the polygon whose face clips
  Feature incident;                ///< of the other
};

/// The incident edge from its first vertex to its second.
template <class Scalar>
using ClipEdge = std::array<ClipEnd<Scalar>, 2>;

/// A vertex, by its index.
inline Feature vertex(int index) {
  return {Feature::Kind::vertex, static_cast<unsigned char>(index)};
}

/// A face, by its index.
inline Feature face(int index) {
  return {Feature::Kind::face, static_cast<unsigned char>(index)};
}

/// One clip of the article ("Clipping"): cuts off what lies behind the line through the reference
/// face's vertex `corner`, widened by `margin`, a length >= 0. `inward` is unit and points along
/// the face, into its slab; both indices name the features of a crossing. False when the edge and
/// the slab do not overlap: fewer than two points are left. A crossing is told by signs, since a
/// product of offsets underflows (Box2D's does: b2ClipSegmentToLine); and it is measured on the
/// whole edge, not on what another clip has left, so that no rounding goes from one crossing into
/// the other.
template <class Scalar>
bool clip(ClipEdge<Scalar>& edge, const ClipEdge<Scalar>& whole, const Vector2<Scalar>& inward,
          const Vector2<Scalar>& corner, Scalar margin, int corner_index, int incident_index) {
  const Vector2<Scalar>& from = whole[0].position;
  const Vector2<Scalar>& to = whole[1].position;
  const Scalar offset0 = inward.dot(from - corner) + margin;
  const Scalar offset1 = inward.dot(to - corner) + margin;
  if (offset0 >= 0 && offset1 >= 0) return true;
  if (offset0 <= 0 && offset1 <= 0) return false;
  const Scalar share = offset0 / (offset0 - offset1);
  const Vector2<Scalar> crossing = from + share * (to - from);
  edge[offset0 < 0 ? 0 : 1] = {crossing, vertex(corner_index), face(incident_index)};
  return true;
}

/// By how much side planes are widened, a length: the total radius where skins are mitred, for
/// these reach past their cores' ends (Box2D 2.4, b2CollidePolygons); round ones end where cores
/// do.
template <class Scalar>
Scalar slab_margin(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b) {
  return are_round(a, b) ? Scalar(0) : a.radius + b.radius;
}

/// The incident edge between the two side planes of the reference face, each widened by `margin`.
/// `along` is unit and points from the face's first end to its second, perpendicular to the
/// contact's normal. Edge and reference stand in one frame. The planes are parallel: neither clip
/// changes what the other cuts off. False where nothing is left.
template <class Scalar>
bool clip_to_slab(ClipEdge<Scalar>& edge, const ConvexPolygon<Scalar>& reference, int face_index,
                  const Vector2<Scalar>& along, Scalar margin, int incident_index) {
  const ClipEdge<Scalar> whole = edge;
  const int first = face_index;
  const int second = reference.next(face_index);
  return clip<Scalar>(edge, whole, along, reference.vertices[first], margin, first,
                      incident_index) &&
         clip<Scalar>(edge, whole, -along, reference.vertices[second], margin, second,
                      incident_index);
}

/// The incident edge before it is clipped: its ends' features are the reference face and its own
/// vertices.
template <class Scalar>
ClipEdge<Scalar> whole_edge(const ConvexPolygon<Scalar>& incident, int first, int reference_face) {
  const int second = incident.next(first);
  return {{{incident.vertices[first], face(reference_face), vertex(first)},
           {incident.vertices[second], face(reference_face), vertex(second)}}};
}

/// Keeps the ends that lie behind the reference face, or no farther in front of it than the total
/// radius, each with its own depth >= 0; walks the incident edge backwards, which is along the
/// reference face. The manifold, of 0, 1 or 2 points, is in the frame of edge and reference. (The
/// article, last clip of "Clipping".)
template <class Scalar>
Manifold<Scalar> keep_behind_face(const ClipEdge<Scalar>& edge,
                                  const ConvexPolygon<Scalar>& reference, int face_index,
                                  Side reference_side, Scalar total_radius) {
  Manifold<Scalar> manifold;
  const Vector2<Scalar>& normal = reference.normals[face_index];
  manifold.reference = reference_side;
  manifold.normal = reference_side == Side::a ? normal : Vector2<Scalar>(-normal);
  for (const int i : {1, 0}) {
    const Scalar separation = normal.dot(edge[i].position - reference.vertices[face_index]);
    if (separation > total_radius) continue;
    FeaturePair features{edge[i].reference, edge[i].incident};
    if (reference_side == Side::b) std::swap(features.a, features.b);
    manifold.points[manifold.count++] = {edge[i].position, total_radius - separation, features};
  }
  return manifold;
}

/// All three clips: the manifold of a reference face and an incident edge, in the polygons' common
/// frame. Empty where the edge misses the slab or lies in front of the face.
template <class Scalar>
Manifold<Scalar> clip_features(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                               const ContactFeatures& features) {
  const bool from_a = features.reference_side == Side::a;
  const ConvexPolygon<Scalar>& reference = from_a ? a : b;
  const ConvexPolygon<Scalar>& incident = from_a ? b : a;
  const Scalar total_radius = a.radius + b.radius;
  const Vector2<Scalar> along = counter_clockwise_quarter(reference.normals[features.reference]);
  ClipEdge<Scalar> edge = whole_edge(incident, features.incident, features.reference);
  if (!clip_to_slab<Scalar>(edge, reference, features.reference, along, slab_margin(a, b),
                            features.incident)) {
    return {};
  }
  return keep_behind_face(edge, reference, features.reference, features.reference_side,
                          total_radius);
}

}  // namespace manifuzz::clipping
