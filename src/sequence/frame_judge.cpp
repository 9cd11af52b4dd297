#include "sequence/frame_judge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include <fmt/format.h>

#include "sequence/kept_point.hpp"

namespace manifuzz {
namespace {

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
  const double turned = off_carried(view.sequence.at(born), view.pair(), point.travels_with,
                                    birth.normal, point.normal);
  const double off = std::max(off_unit, turned);
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

std::vector<FrameJudgement> judge_kept(const FrameView& view, const KeptPoint& point) {
  const KeptPoint& birth = view.birth_of(point);
  std::vector<FrameJudgement> found{judge_anchors(view, point, birth), judge_depth(view, point),
                                    judge_normal(view, point, birth)};
  add_lingering(found, view, point);
  std::erase_if(found, [](const FrameJudgement& judgement) { return !is_wrong(judgement); });
  return found;
}

namespace {

/// The depth of a clip's deepest point, less by how much it may be off.
double least_depth_of(const Admissible& right, const exact::Clip& clip) {
  double most = -std::numeric_limits<double>::infinity();
  for (const exact::ClipPoint& point : points_of(clip)) {
    most = std::max(most, point.depth() - depth_bound(right, clip, point));
  }
  return most;
}

/// Whether a right clip has no point that is deeper, or keeps none. Under a bias, or of faces that
/// rounding cannot tell apart, side planes may cut off the deepest corner.
bool is_as_deep_as_a_clip(const FrameView& view, double depth) {
  const Declaration& declaration = view.subject.declaration;
  if (declaration.claims != Claims::manifold || !declaration.clips) return false;
  const Admissible right =
      admissible(std::make_shared<const exact::Truth>(view.pair()), declaration);
  const auto manifolds = right_manifolds(right);
  if (!manifolds.empty() && manifolds.front().count == 0) return true;
  return std::ranges::any_of(right.candidates, [&](const exact::Clip* clip) {
    return compare_gap(*clip, right.bounds.separation) <= 0 &&
           least_depth_of(right, *clip) <= depth;
  });
}

}  // namespace

FrameJudgement judge_deepest(const FrameView& view) {
  const Declaration& declaration = view.subject.declaration;
  const CurveJudgement none =
      judge_by_curve(view.truth, declaration, Manifold<double>{}, view.bound().frame);
  if (none.kind == Kind::none) return {};
  const double bound = view.bound().missing + tolerance_of(view.truth, declaration);
  const std::vector<KeptPoint>& points = view.points();
  double deepest = -std::numeric_limits<double>::infinity();
  for (const KeptPoint& point : points) deepest = std::max(deepest, point.depth);
  const exact::PenetrationCurve curve(view.truth, exact::skin_of(view.truth));
  if (!points.empty() && curve.compare_least(deepest + bound) <= 0) return {};
  if (is_as_deep_as_a_clip(view, deepest + bound)) return {};
  if (points.empty() || deepest < -bound) {
    return of_length(view, Kind::missed_contact, none.magnitude, none.bound);
  }
  return of_length(view, Kind::depth, curve.least() - deepest, bound);
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
  if (view.frame > 0) {
    found.push_back(judge_extent(view));
    found.push_back(judge_match(view));
  }
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
