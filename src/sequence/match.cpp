#include <algorithm>

#include "sequence/frame_judge.hpp"

// A new point takes the place of an old one that is within the match distance of it: it has that
// one's id, or that one is gone. What is kept beside a new point that took no other's place has to
// be farther away.

namespace manifuzz {
namespace {

/// How far two points are from each other, by those of their anchors that count.
double apart(const KeptPoint& p, const KeptPoint& q, MatchBy by) {
  const double on_a = (p.anchor_a - q.anchor_a).norm();
  const double on_b = (p.anchor_b - q.anchor_b).norm();
  switch (by) {
    case MatchBy::a:
      return on_a;
    case MatchBy::b:
      return on_b;
    case MatchBy::either:
      return std::min(on_a, on_b);
    default:
      return std::max(on_a, on_b);
  }
}

/// Both anchors are compared as they were rounded at birth.
double match_bound(const FrameView& view) {
  return 2 * view.bound().birth.across +
         rounded_limit(view.keeping().match.of(view.pair()), view.subject.declaration) -
         view.keeping().match.of(view.pair());
}

const KeptPoint* find_same(const std::vector<KeptPoint>& points, const KeptPoint& sought) {
  const auto found =
      std::ranges::find_if(points, [&](const KeptPoint& point) { return is_same(point, sought); });
  return found == points.end() ? nullptr : &*found;
}

/// Whether an old point is gone, or has been detected again, whose place the new one may have
/// taken.
bool took_a_place(const FrameView& view, const KeptPoint& born) {
  const double most = view.keeping().match.of(view.pair()) + match_bound(view);
  return std::ranges::any_of(view.points_before(), [&](const KeptPoint& old) {
    return find_same(view.points(), old) == nullptr && apart(born, old, MatchBy::either) <= most;
  });
}

}  // namespace

FrameJudgement judge_match(const FrameView& view) {
  const double match = view.keeping().match.of(view.pair());
  const double bound = match_bound(view);
  const std::vector<KeptPoint>& points = view.points();
  for (const KeptPoint& born : points) {
    if (!view.is_born(born) || took_a_place(view, born)) continue;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const KeptPoint* const before = find_same(view.points_before(), points[i]);
      if (before == nullptr) continue;
      // Points that are anchored anew at each refresh may be compared before it or after.
      const double most = std::max(apart(born, points[i], view.keeping().match_by),
                                   apart(born, *before, view.keeping().match_by));
      if (most >= match - bound) continue;
      return {.kind = Kind::lingering,
              .point = i,
              .magnitude = (match - most) / view.size(),
              .bound = bound / view.size()};
    }
  }
  return {};
}

}  // namespace manifuzz
