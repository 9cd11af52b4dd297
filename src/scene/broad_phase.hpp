#pragma once

#include <cstdint>
#include <vector>

#include "scene/shape_table.hpp"

namespace manifuzz::scene {

/// Bodies by where their boxes are: square cells in levels, each four times as wide as the one
/// below. A body is in one cell, that of its box's middle on the lowest level whose cells are no
/// narrower than the box; so whatever overlaps a box has its middle within half a cell of it. Cells
/// take no memory of their own: bodies are in linked lists by the hash of their cell.
class Grid {
 public:
  /// Puts a body in, or moves it to where its box is now.
  void place(std::uint32_t body, const Box& box);

  /// Of a body that it holds.
  void remove(std::uint32_t body);

  /// Whether a body was placed, and not removed since.
  bool holds(std::uint32_t body) const { return body < entries_.size() && entries_[body].placed; }

  /// Of a body that it holds.
  const Box& box(std::uint32_t body) const { return entries_[body].box; }

  /// Calls `found(body)` for every body whose box overlaps this one.
  template <class Found>
  void near(const Box& box, const Found& found) const;

  /// The memory it takes.
  std::size_t bytes() const;

 private:
  struct Cell {
    int level = 0;
    int x = 0;
    int y = 0;
    friend bool operator==(const Cell&, const Cell&) = default;
  };

  struct Entry {
    Box box;
    Cell cell;
    std::uint32_t next = kNone;
    std::uint32_t previous = kNone;
    bool placed = false;
  };

  /// How many bodies a level holds.
  struct Level {
    int level = 0;
    std::uint32_t bodies = 0;
  };

  /// The cells of a level that a box comes near.
  struct Range {
    int x_min, y_min, x_max, y_max;
    double cells() const { return (1.0 + x_max - x_min) * (1.0 + y_max - y_min); }
  };

  static Cell cell_of(const Box& box);
  static Range range_of(const Box& box, int level);
  std::size_t bucket_of(const Cell& cell) const;
  Level& level_of(int level);
  void link(std::uint32_t body);
  void unlink(std::uint32_t body);
  void widen();

  std::vector<Entry> entries_;          // by body
  std::vector<std::uint32_t> buckets_;  // each list's first body
  std::vector<Level> levels_;           // those ever used
  std::uint32_t placed_ = 0;
};

template <class Found>
void Grid::near(const Box& box, const Found& found) const {
  for (const Level& level : levels_) {
    if (level.bodies == 0) continue;
    const Range range = range_of(box, level.level);
    if (range.cells() > static_cast<double>(placed_)) {  // a giant among dwarfs
      for (std::uint32_t i = 0; i < entries_.size(); ++i) {
        const Entry& entry = entries_[i];
        if (entry.placed && entry.cell.level == level.level && overlap(entry.box, box)) found(i);
      }
      continue;
    }
    for (int y = range.y_min; y <= range.y_max; ++y) {
      for (int x = range.x_min; x <= range.x_max; ++x) {
        const Cell cell{level.level, x, y};
        for (std::uint32_t i = buckets_[bucket_of(cell)]; i != kNone; i = entries_[i].next) {
          // Another cell's bodies may be in the same list.
          if (overlap(entries_[i].box, box) && entries_[i].cell == cell) found(i);
        }
      }
    }
  }
}

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
