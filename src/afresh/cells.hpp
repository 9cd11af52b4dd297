#pragma once

#include <algorithm>
#include <array>
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
  /// So many bodies are best filed, or looked for, together: what they need is asked for first.
  static constexpr std::size_t kTogether = 16;

  /// Files these bodies anew; `boxes` is by body. Each cell has room for so many more, and where
  /// that is not 0 some find room in no cell.
  void file(std::span<const std::uint32_t> bodies, std::span<const Box> boxes, std::uint32_t room);

  /// A body to be filed anew.
  struct Refiled {
    std::uint32_t body;
    const Box* before;  ///< the box with which it is filed; null if it is not
    const Box* box;     ///< the one that it has now
  };
  /// Files `refiled(i)` of each i below the count: in its cell or, where that is full, in one of
  /// the next to the right; where those are full too, or the box is larger than all, in none. False
  /// where there is no room for that, and all must be filed anew.
  template <class Of>
  bool refile(std::size_t count, const Of& refiled);

  /// Asks for all that a search or `refile` may read, where there are many of them to come.
  void ask_for_all() const {
    entries_.ask_for_all();
    for (const CellLevel& level : levels()) scene::ask_for_all(level.begin());
  }

  /// Removes a body that is filed with this box.
  void remove(std::uint32_t body, const Box& box) { entries_.clear(entry_of(place_of(box), body)); }

  /// The bodies whose boxes overlap this one, in no particular order; until the next call.
  std::span<const std::uint32_t> near(const Box& box) {
    runs_.clear();
    find_runs(box, runs_);
    return among(runs_, box, found_);
  }

  /// Entries that lie one after another, from the first to before the last.
  struct Run {
    std::uint32_t first, last;
  };
  /// Adds the runs in which there may be boxes that overlap this one, and asks for them ahead of
  /// `among`.
  void find_runs(const Box& box, std::vector<Run>& runs) const;
  /// Finds the bodies whose boxes overlap this one, among its runs; held by the caller in `found`:
  /// several threads may ask at once.
  std::span<const std::uint32_t> among(std::span<const Run> runs, const Box& box,
                                       Bodies& found) const;

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

  bool refile(const Refiled& refiled, const Place& from, const Place& to);
  void ask_for_entries(const Place& place) const {
    if (place.level < used_) entries_.ask_for(levels_[place.level].begin()[place.place]);
  }

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

  std::vector<Run> runs_;             // of one of the boxes
  std::vector<std::uint32_t> found_;  // by it, and room
};

template <class Of>
bool Cells::refile(std::size_t count, const Of& refiled) {
  std::array<Place, kTogether> from;
  std::array<Place, kTogether> to;
  for (std::size_t first = 0; first < count; first += kTogether) {
    const std::size_t some = std::min(kTogether, count - first);
    for (std::size_t i = 0; i < some; ++i) {
      const Refiled& body = refiled(first + i);
      to[i] = place_of(*body.box);
      from[i] = body.before == nullptr ? to[i] : place_of(*body.before);
    }
    for (std::size_t i = 0; i < some; ++i) {
      ask_for_entries(from[i]);
      ask_for_entries(to[i]);
    }
    for (std::size_t i = 0; i < some; ++i) {
      if (!refile(refiled(first + i), from[i], to[i])) return false;
    }
  }
  return true;
}

}  // namespace manifuzz::scene
