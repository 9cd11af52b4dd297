#include <algorithm>
#include <cmath>

#include "sequence/frame_judge.hpp"
#include "sequence/kept_point.hpp"

// Points that are gone and should not be. A point may go where it has become too stale, where one
// that was detected is at its place, and where there is no room: the deepest stays, and with it, as
// far as there is room, what is farthest to either side.

namespace manifuzz {
namespace {

/// A point of the frame before, as it would be now.
struct Gone {
  const KeptPoint& point;
  Vector2<double> by_a;  ///< its normal at birth, as A carries it
  Vector2<double> by_b;
  double depth = 0;  ///< along whichever of both has less
};

Gone gone_point(const FrameView& view, const KeptPoint& point) {
  const PairCase then = view.sequence.at(static_cast<std::size_t>(point.born));
  const Vector2<double>& normal = view.birth_of(point).normal;
  const Vector2<double> by_a = carried(then, view.pair(), Side::a, normal);
  const Vector2<double> by_b = carried(then, view.pair(), Side::b, normal);
  return {point, by_a, by_b,
          std::min(anchors_now(view.pair(), point, by_a).depth,
                   anchors_now(view.pair(), point, by_b).depth)};
}

/// Whether nothing that is declared lets it go, even if rounding is against it.
bool would_be_kept(const FrameView& view, const Gone& gone) {
  const Keeping& keeping = view.keeping();
  const std::size_t since = view.stale_since(gone.point);
  const double of_turn = carried_normal_bound(view.bounds[since], view.bound(), 1);
  const auto limit = [&](double length) {
    return 2 * length - rounded_limit(length, view.subject.declaration);
  };
  if (turned_since(view.sequence.at(since), view.pair()) > limit(keeping.turn) - of_turn) {
    return false;
  }
  const double bound = view.bound().gap;
  return std::ranges::all_of(std::array{gone.by_a, gone.by_b}, [&](const auto& normal) {
    const AnchorsNow now = anchors_now(view.pair(), gone.point, normal);
    return -now.depth <= limit(keeping.gap.of(view.pair())) - bound &&
           now.drift <= limit(keeping.drift.of(view.pair())) - bound;
  });
}

double match_distance(const FrameView& view) {
  return rounded_limit(view.keeping().match.of(view.pair()), view.subject.declaration) +
         2 * view.bound().birth.across;
}

/// Whether one that was detected is at its place on either body: a corner stays the same point
/// wherever it slides.
bool is_replaced(const FrameView& view, const KeptPoint& gone) {
  const double most = match_distance(view);
  return std::ranges::any_of(view.points(), [&](const KeptPoint& point) {
    return view.is_born(point) && ((point.anchor_a - gone.anchor_a).norm() <= most ||
                                   (point.anchor_b - gone.anchor_b).norm() <= most);
  });
}

double greatest_depth(const FrameView& view) {
  return std::ranges::max(view.points(), {}, &KeptPoint::depth).depth;
}

/// How far a point is to one side of all that are there, at least, whichever of its anchors counts.
double beyond_all(const FrameView& view, const KeptPoint& gone, const Vector2<double>& side) {
  const auto least_and_most = [&](const KeptPoint& point) {
    return std::minmax({place_along(view.pair(), Side::a, point.anchor_a, side),
                        place_along(view.pair(), Side::b, point.anchor_b, side)});
  };
  const double place = least_and_most(gone).first;
  double beyond = std::numeric_limits<double>::infinity();
  for (const KeptPoint& point : view.points()) {
    beyond = std::min(beyond, place - least_and_most(point).second);
  }
  return beyond;
}

bool claims_manifold(const FrameView& view) {
  return view.subject.declaration.claims == Claims::manifold;
}

/// How far the anchors of an end that was detected, and left out, may be apart along the tangent of
/// another normal: no deeper than the deepest, it has them along its own.
double apart_along_tangent(const FrameView& view, const Vector2<double>& normal) {
  if (!claims_manifold(view)) return 0;
  std::vector<Vector2<double>> detected;
  for (const KeptPoint& point : view.points()) {
    if (view.is_born(point)) detected.push_back(point.normal);
  }
  const exact::PenetrationCurve curve(view.truth, exact::skin_of(view.truth));
  for (const Vector2<double>& least : curve.minima(view.bound().birth.minimality)) {
    detected.push_back(world_normal(view.pair(), least));
  }
  double sine = 0;
  for (const Vector2<double>& of : detected) sine = std::max(sine, std::abs(cross(normal, of)));
  return sine * std::max(greatest_depth(view), 0.0);
}

/// By how much it is beyond the others on the side that it is on, whichever of those normals along
/// which the contact may be deepest gives the sides; negative where it is not.
double beyond_on_a_side(const FrameView& view, const Gone& gone) {
  const double least = greatest_depth(view) - view.bound().birth.consistency;
  std::vector<Vector2<double>> normals;
  for (const KeptPoint& point : view.points()) {
    if (point.depth >= least) normals.push_back(point.normal);
  }
  if (gone.depth >= least) normals.insert(normals.end(), {gone.by_a, gone.by_b});
  double beyond = std::numeric_limits<double>::infinity();
  for (const Vector2<double>& normal : normals) {
    const Vector2<double> side = counter_clockwise_quarter(normal);
    const double on_a_side =
        std::max(beyond_all(view, gone.point, side), beyond_all(view, gone.point, -side));
    beyond = std::min(beyond, on_a_side - apart_along_tangent(view, normal));
  }
  return beyond;
}

/// Whether there is room for all points that are farthest to a side.
bool has_room(const FrameView& view) {
  return view.keeping().points_max > 2 ||
         static_cast<int>(view.points().size()) < view.keeping().points_max;
}

FrameJudgement judge_gone(const FrameView& view, const Gone& gone) {
  const double size = view.size();
  const auto found = [&](double magnitude, double bound) -> FrameJudgement {
    return {.kind = Kind::extent, .magnitude = magnitude / size, .bound = bound / size};
  };
  const double bound = view.bound().birth.consistency;
  if (view.points().empty()) {
    return found(gone.depth + view.keeping().gap.of(view.pair()), bound);
  }
  // One end of a manifold may have taken its place and been left out, as others are as deep as they
  // overlap; `judge_deepest` holds them to that.
  const double deeper = gone.depth - greatest_depth(view);
  if (deeper > bound && !claims_manifold(view)) return found(deeper, bound);
  if (!has_room(view)) return {};
  const double beyond = beyond_on_a_side(view, gone);
  const double match = match_distance(view);
  return beyond > match ? found(beyond, match) : FrameJudgement{};
}

}  // namespace

FrameJudgement judge_extent(const FrameView& view) {
  const std::vector<KeptPoint>& before = view.points_before();
  for (std::size_t i = 0; i < before.size(); ++i) {
    const bool is_there = std::ranges::any_of(
        view.points(), [&](const KeptPoint& point) { return is_same(point, before[i]); });
    if (is_there || is_replaced(view, before[i])) continue;
    const Gone gone = gone_point(view, before[i]);
    if (!would_be_kept(view, gone)) continue;
    FrameJudgement judgement = judge_gone(view, gone);
    judgement.point = i;
    if (judgement.kind != Kind::none) return judgement;
  }
  return {};
}

}  // namespace manifuzz
