#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "afresh/cell_level.hpp"
#include "kernel/packed.hpp"

namespace manifuzz::scene {

/// Bodies by their boxes, of any mix of sizes: in levels, each of boxes down to an eighth of its
/// largest, filed by counting.
class Cells {
 public:
  using Bodies = std::vector<std::uint32_t>;  ///< by their indices

  /// Files these bodies anew; `boxes` is by body. Each cell has room for so many more, and where
  /// that is not 0 some find room in no cell.
  void file(std::span<const std::uint32_t> bodies, std::span<const Box> boxes, std::uint32_t room);

  /// Files a body whose box was another one, or that was not there (`before` is null): in its cell
  /// or, where that is full, in one of the next to the right; where those are full too, or the box
  /// is larger than all, in none. False where there is no room for that, and all must be filed
  /// anew.
  bool refile(std::uint32_t body, const Box* before, const Box& box);

  /// Asks for all that a search or `refile` may read, where there are many of them to come.
  void ask_for_all() const {
    entries_.ask_for_all();
    for (const CellLevel& level : levels()) scene::ask_for_all(level.begin());
  }

  /// Removes a body that is filed with this box.
  void remove(std::uint32_t body, const Box& box);

  /// The bodies whose boxes overlap this one, in no particular order; until the next call.
  std::span<const std::uint32_t> near(const Box& box) { return near(box, found_); }
  /// Finds the bodies whose boxes overlap this one, held by the caller in `found`: several threads
  /// may ask at once.
  std::span<const std::uint32_t> near(const Box& box, Bodies& found) const;

  /// Puts all pairs of bodies whose boxes overlap into `found`, each once, a < b; where they have
  /// just been filed without room.
  void pairs(std::vector<kernel::BodyPair>& found);

  /// The memory it takes.
  std::size_t bytes() const;

 private:
  /// A level, and a cell's place there; all that lie in no cell have one level.
  struct Place {
    std::size_t level;
    std::uint32_t place;
    friend bool operator==(const Place&, const Place&) = default;
  };

  void make_levels(std::span<const std::uint32_t> bodies, std::span<const Box> boxes);
  std::size_t level_of(const Box& box) const;
  Place place_of(const Box& box) const;
  /// The entry of a body filed there, or of none, which may be filed there from now on; the
  /// overflow's end if there is none.
  std::uint32_t entry_of(const Place& place, std::uint32_t body);

  std::span<CellLevel> levels() { return std::span(levels_).first(used_); }
  std::span<const CellLevel> levels() const { return std::span(levels_).first(used_); }

  std::vector<CellLevel> levels_;   // the finest first
  std::size_t used_ = 0;            // of them
  BoxColumns entries_;              // of all levels, and behind them the overflow:
  std::uint32_t overflow_ = 0;      // those in no cell, from this one
  std::uint32_t overflow_end_ = 0;  // to before this one

  // While bodies are filed: the level of each body and its place there.
  std::vector<std::uint8_t> level_;
  std::vector<std::uint32_t> place_;

  std::vector<std::uint32_t> found_;  // by one of the boxes, and room
};

}  // namespace manifuzz::scene
