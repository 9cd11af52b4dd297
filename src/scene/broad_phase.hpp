#pragma once

#include "scene/grid.hpp"

namespace manifuzz::scene {

/// How far a box is fattened all round, as a share of its body's reach; and ahead, in steps like
/// the one that left the box, but no farther than the reach.
inline constexpr float kFatShare = 0.1F;
inline constexpr float kFatSteps = 4;

/// Bodies by fattened boxes: only those that left theirs are looked at. What overlaps is a
/// candidate pair.
class BroadPhase {
 public:
  /// Brings a body's padded box up to date; true where it left its fattened box (or had none),
  /// which is then drawn afresh.
  bool update(std::uint32_t body, const Box& box, float reach);

  /// Does nothing to a body that was never updated.
  void remove(std::uint32_t body);

  bool overlap(std::uint32_t body, std::uint32_t other) const {
    return scene::overlap(fat_boxes_[body], fat_boxes_[other]);
  }

  /// Calls `found(other)` for every other body whose fattened box overlaps this one's.
  template <class Found>
  void partners(std::uint32_t body, const Found& found) const {
    grid_.near(fat_boxes_[body], [&](std::uint32_t other) {
      if (other != body && overlap(body, other)) found(other);
    });
  }

  std::size_t bytes() const {
    return (fat_boxes_.capacity() + boxes_.capacity()) * sizeof(Box) + grid_.bytes();
  }

 private:
  std::vector<Box> fat_boxes_;  // by body
  std::vector<Box> boxes_;      // by body, as they last were
  Grid grid_;
};

}  // namespace manifuzz::scene
