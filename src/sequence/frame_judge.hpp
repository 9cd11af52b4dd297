#pragma once

#include <algorithm>

#include "sequence/kept_bounds.hpp"
#include "sequence/sequence_judge.hpp"

namespace manifuzz {

/// Whether two points of different frames are one that was not detected again in between.
inline bool is_same(const KeptPoint& p, const KeptPoint& q) {
  return p.id == q.id && p.born == q.born;
}

/// What is needed to judge one frame of answers that are well formed.
struct FrameView {
  const Sequence& sequence;
  const SequenceCollider& subject;
  std::span<const KeptAnswer> answers;  ///< up to this frame at least
  std::size_t frame = 0;
  const exact::Truth& truth;             ///< of this frame
  std::span<const KeptBounds> bounds{};  ///< of each frame up to this one

  const std::vector<KeptPoint>& points() const { return points_in(frame); }
  /// The points of the frame before; there must be one.
  const std::vector<KeptPoint>& points_before() const { return points_in(frame - 1); }
  const std::vector<KeptPoint>& points_in(std::size_t of) const {
    return std::get<KeptManifold>(answers[of]).points;
  }
  const PairCase& pair() const { return truth.pair(); }
  const KeptBounds& bound() const { return bounds[frame]; }
  double size() const { return truth.size(); }
  const Keeping& keeping() const { return subject.keeping; }
  bool is_born(const KeptPoint& point) const { return point.born == static_cast<int>(frame); }

  /// The point as it was detected. It is of this frame or the one before.
  const KeptPoint& birth_of(const KeptPoint& point) const {
    return *std::ranges::find_if(points_in(point.born),
                                 [&](const KeptPoint& born) { return is_same(born, point); });
  }
  /// The frame since which its drift and turn count.
  std::size_t stale_since(const KeptPoint& point) const {
    return keeping().since == StaleSince::refresh ? frame - 1
                                                  : static_cast<std::size_t>(point.born);
  }
};

/// What is wrong by a world length.
inline FrameJudgement of_length(const FrameView& view, Kind kind, double magnitude, double bound) {
  return {.kind = kind, .magnitude = magnitude / view.size(), .bound = bound / view.size()};
}

/// In words, what an answer says that none can say: a figure that is not finite, too many points,
/// an id twice, a birth in the future, or one that the frame before knows nothing of.
std::optional<std::string> why_malformed(const Keeping& keeping,
                                         std::span<const KeptAnswer> answers, std::size_t frame);

/// A point as a detection of its own, on B's surface, in A's frame.
Manifold<double> detected_on_b(const PairCase& pair, const KeptPoint& point);

/// What is wrong with a point that is born in this frame: by the penetration curve. Of a collider
/// that claims `manifold` it may be a shallower end, whose depth is the overlap there.
FrameJudgement judge_birth(const FrameView& view, const KeptPoint& point);

/// What is wrong with a point that is kept from the frame before: each of its faults.
std::vector<FrameJudgement> judge_kept(const FrameView& view, const KeptPoint& point);

/// Whether the frame's points say that the bodies touch, as deep as they do.
FrameJudgement judge_deepest(const FrameView& view);

/// Whether a point of the frame before is gone that should be there.
FrameJudgement judge_extent(const FrameView& view);

/// Whether a point is kept beside a new one that should have taken its place.
FrameJudgement judge_match(const FrameView& view);

/// Everything that is wrong in a frame.
std::vector<FrameJudgement> judge_frame(const FrameView& view);

}  // namespace manifuzz
