#pragma once

#include <cstdint>
#include <vector>

#include "scene/box.hpp"

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

}  // namespace manifuzz::scene
