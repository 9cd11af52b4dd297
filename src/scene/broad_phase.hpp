#pragma once

#include "scene/grid.hpp"

namespace manifuzz::scene {

/// How far a box is fattened, as shares of its body's reach.
struct Fatness {
  float all_round;  ///< on each side,
  float ahead_max;  ///< and in the direction of its motion, no farther than this,
  float ahead;      ///< a multiple of how far the body went since it was last looked at
};
inline constexpr Fatness kAmongOthers{0.1F, 1, 4};
/// A box without partners may be fat: it costs nothing there.
inline constexpr Fatness kAlone{0.8F, 3, 12};

/// Bodies by fattened boxes: only those that left theirs are looked at. What overlaps is a
/// candidate pair.
class BroadPhase {
 public:
  /// Whether a body that is where `update` last found it, but for this motion, has not left its
  /// fattened box for certain (certificates.md, "Boxes").
  bool is_still_inside(std::uint32_t body, const Pose<float>& pose, float reach) const {
    if (body >= anchors_.size()) return false;
    const Anchor& anchor = anchors_[body];
    return displacement(anchor.pose, pose, reach) < anchor.slack;
  }

  /// Brings a body's padded box at this pose up to date; true where it left its fattened box (or
  /// had none), which is then drawn afresh.
  bool update(std::uint32_t body, const Box& box, const Pose<float>& pose, float reach,
              const Fatness& fatness);

  /// Whether a body was updated, and not removed since.
  bool holds(std::uint32_t body) const { return grid_.holds(body); }

  /// Of a body whose box changes with no motion: its shape is another one.
  void forget_slack(std::uint32_t body) {
    if (body < anchors_.size()) anchors_[body].slack = 0;
  }

  /// Takes a body out; does nothing to one that was never updated.
  void remove(std::uint32_t body);

  /// Whether the fattened boxes of two bodies overlap.
  bool overlap(std::uint32_t body, std::uint32_t other) const {
    return scene::overlap(grid_.box(body), grid_.box(other));
  }

  /// Calls `found(other)` for every other body whose fattened box overlaps this one's.
  template <class Found>
  void partners(std::uint32_t body, const Found& found) const {
    grid_.near(grid_.box(body), [&](std::uint32_t other) {
      if (other != body) found(other);
    });
  }

  /// The memory it takes.
  std::size_t bytes() const { return anchors_.capacity() * sizeof(Anchor) + grid_.bytes(); }

 private:
  /// Where a body was when its box was last looked at, and how far its vertices may move from
  /// there; 0: not at all.
  struct Anchor {
    Pose<float> pose;
    float slack = 0;
  };

  std::vector<Anchor> anchors_;  // by body
  Grid grid_;                    // of the fattened boxes
};

}  // namespace manifuzz::scene
