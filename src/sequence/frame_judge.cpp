#include "sequence/frame_judge.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "sequence/kept_point.hpp"

namespace manifuzz {
namespace {

FrameJudgement of_length(const FrameView& view, Kind kind, double magnitude, double bound) {
  return {.kind = kind, .magnitude = magnitude / view.size(), .bound = bound / view.size()};
}

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

/// By the anchor on A; the one on B is a depth away.
FrameJudgement judge_detection(const FrameView& view, const KeptPoint& point) {
  Declaration declaration = view.subject.declaration;
  declaration.claims = Claims::point;
  declaration.points = PointsAt::surface_a;
  // Across gaps that it keeps it may detect as well, its depth rounded as at birth.
  const double gap = rounded_limit(view.keeping().gap.of(view.pair()), declaration);
  declaration.speculative = std::max(declaration.speculative, gap) + view.bound().birth.consistency;
  const CurveJudgement curve = judge_by_curve(
      view.truth, declaration, detected_at(view.pair(), point, point.anchor_a), view.bound().birth);
  if (curve.kind == Kind::normal || curve.kind == Kind::reversed) {
    return {.kind = curve.kind, .magnitude = curve.magnitude, .bound = curve.bound};
  }
  return of_length(view, curve.kind, curve.magnitude, curve.bound);
}

bool is_wrong(const FrameJudgement& judgement) {
  return judgement.kind != Kind::none;
}

FrameJudgement judge_anchors(const FrameView& view, const KeptPoint& point,
                             const KeptPoint& birth) {
  if (view.keeping().since == StaleSince::refresh) return {};
  const double moved =
      std::max((point.anchor_a - birth.anchor_a).norm(), (point.anchor_b - birth.anchor_b).norm());
  const double bound = view.bound().frame.across;
  return moved > bound ? of_length(view, Kind::position, moved, bound) : FrameJudgement{};
}

FrameJudgement judge_depth(const FrameView& view, const KeptPoint& point) {
  const double off = std::abs(point.depth - anchors_now(view.pair(), point, point.normal).depth);
  const double bound = view.bound().gap;
  return off > bound ? of_length(view, Kind::inconsistent, off, bound) : FrameJudgement{};
}

FrameJudgement judge_normal(const FrameView& view, const KeptPoint& point, const KeptPoint& birth) {
  const auto born = static_cast<std::size_t>(point.born);
  const bool is_renewed = view.keeping().since == StaleSince::refresh;
  const int refreshes = is_renewed ? static_cast<int>(view.frame - born) : 1;
  const double bound = carried_normal_bound(view.bounds[born], view.bound(), refreshes);
  const double off_unit = std::abs(point.normal.norm() - 1);
  const double off = std::max(
      off_unit, off_carried(view.sequence.at(born), view.pair(), birth.normal, point.normal));
  if (off <= bound) return {};
  return {.kind = Kind::normal, .magnitude = off, .bound = bound};
}

/// What is beyond a limit by more than a bound.
void add_beyond(std::vector<FrameJudgement>& found, double value, double limit, double bound,
                double size) {
  if (!(value > limit + bound)) return;
  found.push_back(
      {.kind = Kind::lingering, .magnitude = (value - limit) / size, .bound = bound / size});
}

/// The drift of a point that is anchored anew each time is that of its last anchors.
const KeptPoint& anchored(const FrameView& view, const KeptPoint& point) {
  if (view.keeping().since == StaleSince::birth) return point;
  return *std::ranges::find_if(view.points_before(),
                               [&](const KeptPoint& last) { return is_same(last, point); });
}

void add_lingering(std::vector<FrameJudgement>& found, const FrameView& view,
                   const KeptPoint& point) {
  const Keeping& keeping = view.keeping();
  const Declaration& declaration = view.subject.declaration;
  const std::size_t since = view.stale_since(point);
  const auto limit = [&](double length) { return rounded_limit(length, declaration); };
  const AnchorsNow now = anchors_now(view.pair(), point, point.normal);
  const AnchorsNow slid = anchors_now(view.pair(), anchored(view, point), point.normal);
  const double bound = view.bound().gap;
  add_beyond(found, -now.depth, limit(keeping.gap.of(view.pair())), bound, view.size());
  add_beyond(found, slid.drift, limit(keeping.drift.of(view.pair())), bound, view.size());
  add_beyond(found, turned_since(view.sequence.at(since), view.pair()), limit(keeping.turn),
             carried_normal_bound(view.bounds[since], view.bound(), 1), 1);
}

}  // namespace

FrameJudgement judge_birth(const FrameView& view, const KeptPoint& point) {
  FrameJudgement found = judge_detection(view, point);
  if (is_wrong(found)) return found;
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

std::vector<FrameJudgement> judge_kept(const FrameView& view, const KeptPoint& point) {
  const KeptPoint& birth = view.birth_of(point);
  std::vector<FrameJudgement> found{judge_anchors(view, point, birth), judge_depth(view, point),
                                    judge_normal(view, point, birth)};
  add_lingering(found, view, point);
  std::erase_if(found, [](const FrameJudgement& judgement) { return !is_wrong(judgement); });
  return found;
}

FrameJudgement judge_deepest(const FrameView& view) {
  const Declaration& declaration = view.subject.declaration;
  const CurveJudgement none =
      judge_by_curve(view.truth, declaration, Manifold<double>{}, view.bound().frame);
  if (none.kind == Kind::none) return {};
  const double bound = view.bound().missing + tolerance_of(view.truth, declaration);
  const std::vector<KeptPoint>& points = view.points();
  const auto deepest = std::ranges::max_element(points, {}, &KeptPoint::depth);
  if (deepest == points.end() || deepest->depth < -bound) {
    return of_length(view, Kind::missed_contact, none.magnitude, none.bound);
  }
  const exact::PenetrationCurve curve(view.truth, exact::skin_of(view.truth));
  if (curve.compare_least(deepest->depth + bound) <= 0) return {};
  return of_length(view, Kind::depth, curve.least() - deepest->depth, bound);
}

std::vector<FrameJudgement> judge_frame(const FrameView& view) {
  std::vector<FrameJudgement> found;
  const std::vector<KeptPoint>& points = view.points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    auto of_point = view.is_born(points[i]) ? std::vector{judge_birth(view, points[i])}
                                            : judge_kept(view, points[i]);
    for (FrameJudgement& judgement : of_point) {
      judgement.point = i;
      found.push_back(judgement);
    }
  }
  found.push_back(judge_deepest(view));
  if (view.frame > 0) found.push_back(judge_extent(view));
  std::erase_if(found, [](const FrameJudgement& judgement) { return !is_wrong(judgement); });
  return found;
}

std::optional<std::string> why_malformed(const Keeping& keeping,
                                         std::span<const KeptAnswer> answers, std::size_t frame) {
  const std::vector<KeptPoint>& points = std::get<KeptManifold>(answers[frame]).points;
  if (static_cast<int>(points.size()) > keeping.points_max) {
    return fmt::format("{} points; at most {} are expected", points.size(), keeping.points_max);
  }
  for (auto point = points.begin(); point != points.end(); ++point) {
    const double sum = point->anchor_a.sum() + point->anchor_b.sum() + point->normal.sum();
    if (!std::isfinite(sum + point->depth)) {
      return fmt::format("point {} has a figure that is not finite", point->id);
    }
    if (std::any_of(points.begin(), point,
                    [&](const KeptPoint& other) { return other.id == point->id; })) {
      return fmt::format("two points have the id {}", point->id);
    }
    if (point->born == static_cast<int>(frame)) continue;
    const bool is_known =
        frame > 0 &&
        std::ranges::any_of(std::get<KeptManifold>(answers[frame - 1]).points,
                            [&](const KeptPoint& old) { return is_same(old, *point); });
    if (!is_known) {
      return fmt::format("point {} is born in frame {}, and not there in the frame before",
                         point->id, point->born);
    }
  }
  return std::nullopt;
}

}  // namespace manifuzz
