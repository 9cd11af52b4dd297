#include "sequence/kept_bounds.hpp"

#include <algorithm>
#include <iostream>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "own_colliders/own_colliders.hpp"
#include "sequence/frame_judge.hpp"
#include "sequence/kept_point.hpp"
#include "sequence/motions.hpp"

namespace manifuzz {
namespace {

/// The largest errors of right answers, each over its bound.
struct Closest {
  double depth = 0;           ///< of a kept point, against its anchors' gap
  double normal = 0;          ///< of a kept point
  double depth_at_birth = 0;  ///< against the anchors' gap
  double drift_at_birth = 0;
  double missing = 0;  ///< of the deepest

  void add(const FrameView& view, const KeptPoint& point) {
    const AnchorsNow now = anchors_now(view.pair(), point, point.normal);
    const KeptBounds& bound = view.bound();
    if (view.is_born(point)) {
      depth_at_birth =
          std::max(depth_at_birth, std::abs(point.depth - now.depth) / bound.birth.consistency);
      drift_at_birth = std::max(drift_at_birth, now.drift / (2 * bound.birth.across));
      return;
    }
    const auto born = static_cast<std::size_t>(point.born);
    const double off = off_carried(view.sequence.at(born), view.pair(), point.travels_with,
                                   view.birth_of(point).normal, point.normal);
    depth = std::max(depth, std::abs(point.depth - now.depth) / bound.gap);
    normal = std::max(normal, off / carried_normal_bound(view.bounds[born], bound, 1));
  }

  void add_deepest(const FrameView& view) {
    const exact::PenetrationCurve curve(view.truth, exact::skin_of(view.truth));
    const CurveJudgement none = judge_by_curve(view.truth, view.subject.declaration,
                                               Manifold<double>{}, view.bound().frame);
    if (view.points().empty() || none.kind == Kind::none) return;
    const double deepest = std::ranges::max(view.points(), {}, &KeptPoint::depth).depth;
    missing = std::max(missing, (curve.least() - deepest) / view.bound().missing);
  }

  double most() const { return std::max({depth, normal, depth_at_birth, drift_at_birth, missing}); }
};

Closest closest_of(const SequenceCollider& subject, const Motion& motion) {
  Closest closest;
  for (std::uint64_t i = 0; i < 200; ++i) {
    const Sequence sequence = draw_sequence(11, motion, i);
    const auto answers = ask_sequence(subject, sequence);
    std::vector<KeptBounds> bounds;
    for (std::size_t frame = 0; frame < answers.size(); ++frame) {
      const exact::Truth truth(sequence.at(frame));
      bounds.push_back(kept_bounds(truth, subject.declaration));
      const FrameView view{sequence, subject, answers, frame, truth, bounds};
      for (const KeptPoint& point : view.points()) closest.add(view, point);
      closest.add_deepest(view);
    }
  }
  return closest;
}

}  // namespace

TEST_CASE("kept points come close to their bounds and never exceed them") {
  std::cout << fmt::format("{:<10} {:<17} {:>6} {:>7} {:>11} {:>11} {:>8}\n", "collider", "motion",
                           "depth", "normal", "birth depth", "birth drift", "deepest");
  Closest all;
  for (const SequenceCollider& subject : {make_cached(), make_cached64()}) {
    for (const Motion& motion : motions()) {
      const Closest c = closest_of(subject, motion);
      std::cout << fmt::format("{:<10} {:<17} {:>6.3f} {:>7.3f} {:>11.3f} {:>11.3f} {:>8.3f}\n",
                               subject.declaration.name, motion.name, c.depth, c.normal,
                               c.depth_at_birth, c.drift_at_birth, c.missing);
      CHECK(c.most() <= 1);
      all.normal = std::max(all.normal, c.normal);
      all.depth = std::max(all.depth, c.depth);
    }
  }
  // A bound that no answer comes near would excuse bugs.
  CHECK(all.depth > 0.05);
  CHECK(all.normal > 0.05);
}

}  // namespace manifuzz
