#include "measure/stress/walk_changes.hpp"

#include <algorithm>
#include <cmath>

namespace manifuzz {
namespace {

void count(Changes& changes, std::uint64_t frame, bool with_margin) {
  if (!with_margin) {
    ++changes.within_bound;
    return;
  }
  if (changes.with_margin == 0) changes.first = frame;
  ++changes.with_margin;
}

/// The longest distance of a point between two manifolds of as many points.
double longest_move(const Manifold<double>& from, const Manifold<double>& to) {
  double longest = 0;
  for (int i = 0; i < from.count; ++i) {
    const Vector2<double> apart = to.points[i].position - from.points[i].position;
    longest = std::max(longest, std::sqrt(apart.dot(apart)));
  }
  return longest;
}

bool has_same_features(const Manifold<double>& m, const Manifold<double>& n) {
  if (m.count != n.count) return false;
  for (int i = 0; i < m.count; ++i) {
    if (m.points[i].features != n.points[i].features) return false;
  }
  return true;
}

}  // namespace

WalkChangeCounter::Frame WalkChangeCounter::frame_of(const Manifold<double>& manifold,
                                                     const Manifold<double>& truth,
                                                     const Admissible& right) {
  Frame now{.manifold = manifold, .truth = truth};
  const auto& candidates = right.candidates;
  if (candidates.empty()) return now;
  const exact::Clip& first = *candidates.front();
  const bool one_side = std::ranges::all_of(candidates, [&](const exact::Clip* clip) {
    return clip->reference.side == first.reference.side;
  });
  if (one_side) now.reference = first.reference.side;
  const bool decided =
      std::all_of(first.points.begin(), first.points.begin() + first.count, [&](const auto& point) {
        return features_decided(right, first, point) &&
               std::abs(point.depth()) > depth_bound(right, first, point);
      });
  if (candidates.size() == 1 && first.count == 2 && decided) {
    now.only = first.reference;
    now.incident = first.incident;
  }
  for (const exact::Clip* clip : candidates) {
    for (int i = 0; i < clip->count; ++i) {
      now.bound = std::max(now.bound, position_bound(right, *clip, clip->points[i]));
    }
  }
  return now;
}

void WalkChangeCounter::compare(std::uint64_t frame, const Frame& now) {
  const bool is_decided =
      now.only && before_->only == now.only && before_->incident == now.incident;
  if (before_->truth.reference == now.truth.reference &&
      before_->manifold.reference != now.manifold.reference) {
    count(changes_.flickers, frame, now.reference && before_->reference == now.reference);
  }
  if (!has_same_features(before_->truth, now.truth)) return;
  if (!has_same_features(before_->manifold, now.manifold)) {
    count(changes_.features, frame, is_decided);
  }
  if (before_->manifold.count == now.manifold.count &&
      longest_move(before_->manifold, now.manifold) >
          longest_move(before_->truth, now.truth) + before_->bound + now.bound) {
    count(changes_.jumps, frame, is_decided);
  }
}

void WalkChangeCounter::add(std::uint64_t frame, Referee& referee, const Declaration& declaration,
                            const Answer& answer) {
  const Manifold<double>& truth = referee.truth_for(declaration);
  if (truth.count > 0) ++changes_.touching;
  const auto* const manifold = std::get_if<Manifold<double>>(&answer);
  if (manifold == nullptr || manifold->count == 0 || truth.count == 0) {
    before_.reset();
    return;
  }
  const Frame now = frame_of(*manifold, truth, referee.right_for(declaration));
  if (before_) compare(frame, now);
  before_ = now;
}

}  // namespace manifuzz
