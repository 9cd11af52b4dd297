#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/placed.hpp"
#include "judging/faults/shared_faults.hpp"
#include "judging/manifold_error.hpp"
#include "oracle/box2d/deviations.hpp"

// Box2D 2.4 on polygons.

namespace manifuzz {

using namespace ledger_of;

namespace {

/// The reference face as float colliders have it, in its polygon's own frame.
Vector2<float> float_face(const exact::Clip& clip) {
  const auto& [side, face] = clip.reference;
  const exact::StoredPolygon& polygon = (*clip.pair)[side].polygon;
  return polygon.vertices[polygon.next(face)].cast<float>() - polygon.vertices[face].cast<float>();
}

/// Whether one end of an incident edge is beside an end of the face by what float has no normal
/// number for.
bool is_beside_end(const exact::RoughPair& placed, exact::FaceOf face, int incident) {
  const exact::RoughPolygon& on = placed[face.side];
  const exact::RoughPolygon& of = placed[other(face.side)];
  const Vector2<double> along(-on.normals[face.index].y(), on.normals[face.index].x());
  for (const int end : {face.index, on.next(face.index)}) {
    for (const int vertex : {incident, of.next(incident)}) {
      const double margin = std::abs((of.vertices[vertex] - on.vertices[end]).dot(along));
      if (margin > 0 && margin <= double{std::numeric_limits<float>::min()}) return true;
    }
  }
  return false;
}

/// Whether that is so of any clip of a segment or capsule and a polygon, for the bias may take one
/// that is not right.
bool is_edge_beside_end(const Deviation& d) {
  const PairCase& pair = d.right.pair();
  if (pair.a.polygon.count != 2 && pair.b.polygon.count != 2) return false;
  const exact::RoughPair placed = exact::place_roughly(d.right.truth->stored());
  for (const Side side : {Side::a, Side::b}) {
    for (int i = 0; i < pair[side].polygon.face_count(); ++i) {
      const exact::FaceOf face{side, i};
      const auto incident = d.right.truth->incident_edges(face, d.right.bounds.incident_dot);
      const auto is_beside = [&](int edge) { return is_beside_end(placed, face, edge); };
      if (std::ranges::any_of(incident, is_beside)) return true;
    }
  }
  return false;
}

}  // namespace

bool no_contact_under_bias(const Deviation& d) {
  return misses_overlap(d) && d.right.truth->compare_lead_of_b(0) > 0 &&
         may_be_empty_from(d, Side::a);
}

bool tiny_reference_face(const Deviation& d) {
  if (d.kind != Kind::normal && d.kind != Kind::missed_contact) return false;
  const double unresolved =
      std::max(d.right.bounds.separation, 2.0 * std::numeric_limits<float>::epsilon());
  return any_candidate(d, [&](const exact::Clip& clip) {
    return static_cast<double>(float_face(clip).norm()) <= unresolved;
  });
}

bool huge_reference_face(const Deviation& d) {
  if (d.kind != Kind::normal && d.kind != Kind::missed_contact) return false;
  return any_candidate(d, [](const exact::Clip& clip) {
    const Vector2<float> face = float_face(clip);
    return !std::isfinite(face.dot(face));
  });
}

bool crossing_underflows(const Deviation& d) {
  const auto underflows = [&](const exact::Clip& clip) {
    return std::ranges::any_of(points_of(clip), [&](const exact::ClipPoint& point) {
      return compare_margin(clip, point.end, std::numeric_limits<float>::min()) <= 0;
    });
  };
  return (misses_overlap(d) && any_candidate(d, underflows)) ||
         (d.kind == Kind::missed_contact && is_edge_beside_end(d));
}

}  // namespace manifuzz
