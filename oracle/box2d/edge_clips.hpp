#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "exact/placed.hpp"
#include "judging/ledger.hpp"

namespace manifuzz::ledger_of {

// An edge against a polygon as Box2D 2.4 clips it, in world directions seen from A's position.

/// The sides of an edge against a polygon, which are A's and B's or B's and A's.
struct EdgeAndPolygon {
  Side edge = Side::a;
  Side polygon = Side::b;
};

inline std::optional<EdgeAndPolygon> edge_and_polygon(const PairCase& pair) {
  for (const Side side : {Side::a, Side::b}) {
    if (pair[side].polygon.count == 2 && pair[other(side)].polygon.count >= kMinVertices) {
      return EdgeAndPolygon{side, other(side)};
    }
  }
  return std::nullopt;
}

/// What is left of an incident edge between the ends of a reference face.
struct BetweenEnds {
  Vector2<double> normal;  ///< from A to B, in the world
  double run = 0;          ///< along the face; negative where it misses
  double nearest = 0;      ///< to the face, of what is left
  double slack = 0;        ///< of `nearest`: an end that is cut moves along a slope
  bool is_cut = false;     ///< the end nearest to the face is beyond the face's ends, or nearly
};

inline BetweenEnds between_ends(const exact::RoughPair& placed, exact::FaceOf reference,
                                int incident, double bound) {
  const exact::RoughPolygon& on = placed[reference.side];
  const exact::RoughPolygon& of = placed[other(reference.side)];
  const Vector2<double>& out = on.normals[reference.index];
  const Vector2<double> along(-out.y(), out.x());
  const Vector2<double>& corner = on.vertices[reference.index];
  const Vector2<double> face = on.vertices[on.next(reference.index)] - corner;
  Vector2<double> first = of.vertices[incident] - corner;
  Vector2<double> last = of.vertices[of.next(incident)] - corner;
  if (first.dot(along) > last.dot(along)) std::swap(first, last);
  const double low = std::max(first.dot(along), 0.0);
  const double high = std::min(last.dot(along), face.dot(along));
  const double rise = std::abs((last - first).dot(out));
  const double run = (last - first).dot(along);
  const auto height_at = [&](double place) {
    if (!(run > 0)) return std::min(first.dot(out), last.dot(out));
    const double share = std::clamp((place - first.dot(along)) / run, 0.0, 1.0);
    return first.dot(out) + share * (last - first).dot(out);
  };
  const double deepest = (first.dot(out) < last.dot(out) ? first : last).dot(along);
  return {.normal = reference.side == Side::a ? out : Vector2<double>(-out),
          .run = high - low,
          .nearest = std::min(height_at(low), height_at(high)),
          .slack = bound + (run > 0 ? std::min(bound * rise / run, rise) : rise),
          .is_cut = deepest <= 2 * bound || deepest >= face.dot(along) - 2 * bound};
}

/// Whether the answer is what that clip gives: no contact where nothing is left, or the face's
/// normal with the depth of what is.
inline bool is_given_by(const Deviation& d, const BetweenEnds& clip) {
  const Bounds& bounds = d.right.bounds;
  const PairCase& pair = d.right.pair();
  const double radius = total_radius(pair);
  if (d.got.count == 0) {
    return clip.run <= 2 * bounds.separation || clip.nearest >= radius - clip.slack;
  }
  const Vector2<double> normal =
      rotate<double>(pair.a.pose.rotation.cast<double>(), d.got.normal).normalized();
  if ((normal - clip.normal).norm() > 2 * bounds.normal) return false;
  double deepest = 0;
  for (int i = 0; i < d.got.count; ++i) deepest = std::max(deepest, d.got.points[i].depth);
  const double turned = bounds.normal * (d.right.truth->extent() + radius);
  return std::abs(deepest - (radius - clip.nearest)) <= clip.slack + turned;
}

/// Whether the answer is what a face makes it, of which `is_at_fault` tells.
template <class Fault>
bool is_clip_from(const Deviation& d, exact::FaceOf face, const Fault& is_at_fault) {
  const exact::Truth& truth = *d.right.truth;
  const Bounds& bounds = d.right.bounds;
  const exact::RoughPair placed = exact::place_roughly(truth.stored());
  return std::ranges::any_of(truth.incident_edges(face, bounds.incident_dot), [&](int incident) {
    const BetweenEnds clip = between_ends(placed, face, incident, bounds.separation);
    return is_at_fault(clip) && is_given_by(d, clip);
  });
}

/// Whether the answer is what one of the best faces of that side makes it.
template <class Fault>
bool any_clip_from(const Deviation& d, Side side, const Fault& is_at_fault) {
  const exact::Truth& truth = *d.right.truth;
  for (int i = 0; i < d.right.pair()[side].polygon.face_count(); ++i) {
    const exact::FaceOf face{side, i};
    if (truth.separation(face) < truth.separation(side) - 2 * d.right.bounds.separation) continue;
    if (is_clip_from(d, face, is_at_fault)) return true;
  }
  return false;
}

}  // namespace manifuzz::ledger_of
