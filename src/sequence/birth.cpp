#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "exact/witness.hpp"
#include "sequence/frame_judge.hpp"
#include "sequence/kept_point.hpp"

// A point that is born. Its normal is one along which they overlap least; it lies on A's surface,
// where the overlap along the normal is its depth, and on B's a depth away. Of a collider that
// claims one point it is the deepest place. One that claims a manifold gives both ends of a contact
// and may leave out the deeper one, where it keeps another that is as deep: `judge_deepest` holds
// all points of the frame to that.

namespace manifuzz {
namespace {

/// The point as a detection of its own, on one side's surface, in A's frame.
Manifold<double> detected_at(const PairCase& pair, const KeptPoint& point,
                             const Vector2<double>& place) {
  Manifold<double> manifold;
  manifold.count = 1;
  manifold.normal = local_normal(pair, point.normal);
  manifold.points[0].position = place;
  manifold.points[0].depth = point.depth;
  return manifold;
}

/// A place on a body's outline as seen along a normal.
struct SeenPlace {
  double off = 0;     ///< how far it is along the tangent from the place that was asked for
  double height = 0;  ///< along the normal
};

/// The place of a side's core that faces the other body where it is nearest, along the tangent, to
/// `at`.
SeenPlace core_place(const PairCase& pair, Side side, const Vector2<double>& normal, double at) {
  const double outward = side == Side::a ? 1 : -1;
  const Vector2<double> tangent = counter_clockwise_quarter(normal);
  const ConvexPolygon<float>& core = pair[side].polygon;
  SeenPlace nearest{std::numeric_limits<double>::infinity(), 0};
  for (int i = 0; i < core.count; ++i) {
    const auto seen = [&](int vertex) -> Vector2<double> {
      const Vector2<double> corner = core.vertices[vertex].cast<double>();
      return {place_along(pair, side, corner, tangent), place_along(pair, side, corner, normal)};
    };
    const Vector2<double> from = seen(i);
    const Vector2<double> to = seen((i + 1) % core.count);
    const auto [low, high] = std::minmax({from.x(), to.x()});
    const double place = std::clamp(at, low, high);
    const double share = high > low ? (place - from.x()) / (to.x() - from.x()) : 0;
    const double height = from.y() + share * (to.y() - from.y());
    const double off = std::abs(place - at);
    const bool is_farther_out = outward * height > outward * nearest.height;
    if (off < nearest.off || (off == nearest.off && is_farther_out)) nearest = {off, height};
  }
  return nearest;
}

/// By how much a point would have to move, or its depth to change, so that it is where they overlap
/// by its depth.
double place_error(const PairCase& pair, const KeptPoint& point) {
  const Vector2<double> tangent = counter_clockwise_quarter(point.normal);
  const double at = place_along(pair, Side::a, point.anchor_a, tangent);
  const SeenPlace top = core_place(pair, Side::a, point.normal, at);
  const SeenPlace bottom = core_place(pair, Side::b, point.normal, at);
  const double surface = top.height + static_cast<double>(pair.a.polygon.radius);
  const double above = place_along(pair, Side::a, point.anchor_a, point.normal) - surface;
  const double overlap = top.height - bottom.height + total_radius(pair);
  return std::max({top.off, bottom.off, std::abs(above), std::abs(point.depth - overlap)});
}

/// Whether no other normal has clearly less depth. Across a gap any will do, but not past the end
/// of an overlap.
bool is_normal_right(const FrameView& view, const Declaration& declaration,
                     const Manifold<double>& detected) {
  const CurveBounds& bounds = view.bound().birth;
  const exact::PenetrationCurve curve(view.truth, exact::skin_of(view.truth));
  const bool is_across_gap =
      detected.points[0].depth < 0 && curve.compare_least(bounds.minimality) <= 0;
  // Whatever the depth, the curve's judge says whether the normal is one of the least.
  const Penetration along{.touches = true, .normal = detected.normal, .depth = 0};
  const CurveJudgement of_normal = judge_by_curve(view.truth, declaration, along, bounds);
  return of_normal.minimal && (is_across_gap || *of_normal.minimal);
}

/// Whether it is a point of some right contact, the deepest or not: it lies on A's surface, and its
/// depth is the overlap there along a right normal.
bool is_contact_point(const FrameView& view, const Declaration& declaration,
                      const Manifold<double>& detected) {
  const CurveBounds& bounds = view.bound().birth;
  const auto& [position, depth, features] = detected.points[0];
  if (depth < -declaration.speculative - bounds.consistency) return false;
  if (!is_normal_right(view, declaration, detected)) return false;
  const PairCase& pair = view.pair();
  const double tolerance = tolerance_of(view.truth, declaration);
  const std::array on_a{exact::Height{1, 0, static_cast<double>(pair.a.polygon.radius)}};
  // Clips reach past mitred cores by their radii.
  const double past_ends = is_round(pair) ? 0 : total_radius(pair);
  return exact::is_witness(view.truth, exact::Along(view.truth, detected.normal),
                           {.position = position,
                            .heights = on_a,
                            .gap_least = depth,
                            .gap_most = depth,
                            .along = bounds.along + tolerance + past_ends,
                            .across = bounds.across + tolerance,
                            .slack = bounds.consistency + tolerance,
                            .narrow = bounds.narrow});
}

bool is_deepest_born(const FrameView& view, const KeptPoint& point) {
  return std::ranges::none_of(view.points(), [&](const KeptPoint& other) {
    return view.is_born(other) && other.depth > point.depth;
  });
}

FrameJudgement as_found(const FrameView& view, const CurveJudgement& curve) {
  if (curve.kind == Kind::normal || curve.kind == Kind::reversed) {
    return {.kind = curve.kind, .magnitude = curve.magnitude, .bound = curve.bound};
  }
  return of_length(view, curve.kind, curve.magnitude, curve.bound);
}

/// By the anchor on A; the one on B is a depth away.
FrameJudgement judge_detection(const FrameView& view, const KeptPoint& point) {
  const CurveBounds& bounds = view.bound().birth;
  Declaration declaration = view.subject.declaration;
  declaration.claims = Claims::point;
  declaration.points = PointsAt::surface_a;
  // Across gaps that it keeps it may detect as well, its depth rounded as at birth.
  const double gap = rounded_limit(view.keeping().gap.of(view.pair()), declaration);
  declaration.speculative = std::max(declaration.speculative, gap) + bounds.consistency;
  const Manifold<double> detected = detected_at(view.pair(), point, point.anchor_a);
  const bool is_of_many = view.subject.declaration.claims == Claims::manifold;
  if (is_of_many && is_contact_point(view, declaration, detected)) return {};
  const CurveJudgement curve = judge_by_curve(view.truth, declaration, detected, bounds);
  const bool may_be_shallow = is_of_many && !is_deepest_born(view, point);
  if (!may_be_shallow || curve.kind != Kind::inconsistent) return as_found(view, curve);
  // Its depth need not be the deepest, so that something else is wrong with it.
  if (!curve.minimal.value_or(true)) {
    return of_length(view, Kind::not_minimal, std::abs(*curve.excess), bounds.minimality);
  }
  return of_length(view, Kind::witness, place_error(view.pair(), point), bounds.along);
}

}  // namespace

FrameJudgement judge_birth(const FrameView& view, const KeptPoint& point) {
  const FrameJudgement found = judge_detection(view, point);
  if (found.kind != Kind::none) return found;
  const AnchorsNow now = anchors_now(view.pair(), point, point.normal);
  const KeptBounds& bound = view.bound();
  const double off = std::abs(point.depth - now.depth);
  if (off > bound.birth.consistency) {
    return of_length(view, Kind::inconsistent, off, bound.birth.consistency);
  }
  if (now.drift > 2 * bound.birth.across) {
    return of_length(view, Kind::witness, now.drift, 2 * bound.birth.across);
  }
  return {};
}

Manifold<double> detected_on_b(const PairCase& pair, const KeptPoint& point) {
  return detected_at(pair, point, anchor_b_in_a(pair, point));
}

}  // namespace manifuzz
