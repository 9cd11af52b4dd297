#pragma once

#include <array>
#include <cassert>
#include <cstdint>
#include <deque>
#include <optional>
#include <unordered_map>
#include <vector>

#include "campaign/hunts/filled_cells.hpp"
#include "geometry/pair_case.hpp"
#include "hunting/observation.hpp"

namespace manifuzz {

/// A place in an archive's list of cases. Once its case is freed, another case may get it.
using EntryId = std::uint32_t;

/// Sets of cells that share their cases: a cell for each pair of conditions with their bins, and
/// one for each tuple of labels with a bin of depth, tilt or margin, once of all labels and once
/// without the numbers of face and edge; and one for both counts of vertices with a bin of depth,
/// tilt, margin, scale, or of a ratio of sizes or radii. Each holds the case of the greatest value,
/// the first of equals.
class Archive {
 public:
  struct Entry {
    PairCase pair;
    Observation observed;
    double value = 0;
    CaseNumber number = 0;    ///< whoever adds it sets this
    std::uint32_t cells = 0;  ///< that hold it
    std::uint32_t holds = 0;  ///< of others
    std::uint32_t uses = 0;   ///< as a parent
  };

  /// How many cells a case fills that were empty, and where it is kept if it takes any.
  struct Taken {
    std::uint32_t new_cells = 0;
    std::optional<EntryId> entry{};
  };

  Archive();

  /// Takes in a case with this observation and this value. `pair_of` makes the case if it is kept.
  template <class PairOf>
  Taken add(const Observation& observed, double value, const PairOf& pair_of) {
    std::vector<Cell*> won;
    Taken taken{find_won(observed, value, won)};
    if (won.empty()) return taken;
    taken.entry = put(pair_of(), observed, value);
    for (Cell* const cell : won) take(*cell, *taken.entry);
    return taken;
  }

  /// The sets of cells.
  enum class Set { pairs, labels, kinds, counts };
  static constexpr std::size_t kTupleSets = 3;  ///< all but pairs

  /// How many cells of a set are filled.
  std::size_t cell_count(Set set) const {
    return set == Set::pairs ? filled_pairs_.size() : tuples_of(set).cells.size();
  }
  std::size_t cell_count() const {
    std::size_t cells = filled_pairs_.size();
    for (const Tuples& tuples : tuples_) cells += tuples.cells.size();
    return cells;
  }
  FilledCells filled() const { return {cell_count(), cell_count(Set::pairs)}; }
  bool is_empty() const { return cell_count() == 0; }

  struct Cell {
    EntryId entry = 0;
    bool is_filled = false;
    std::uint64_t visits = 0;  ///< cases that belong into it
    double value = 0;
  };
  /// A set's k-th filled cell, in the order in which they were filled.
  const Cell& cell(Set set, std::size_t k) const {
    return set == Set::pairs ? pair_cells_[filled_pairs_[k]] : tuples_of(set).cells[k];
  }
  /// The cases that were added last, the oldest first, as far as they still hold a cell.
  std::vector<EntryId> newest(std::size_t most) const;

  /// Every case that holds a cell or is held.
  std::vector<EntryId> all() const;

  const Entry& operator[](EntryId id) const { return entries_[id]; }
  Entry& operator[](EntryId id) { return entries_[id]; }

  /// A case without a cell: to be held.
  EntryId put(const PairCase& pair, const Observation& observed, double value);

  /// Keeps a case that may lose its last cell, until it is let go.
  void hold(EntryId id) { ++entries_[id].holds; }
  void let_go(EntryId id);

 private:
  /// The cells of tuples of labels.
  struct Tuples {
    std::deque<Cell> cells;  ///< pointers to them stay
    std::unordered_map<std::uint64_t, std::uint32_t> places;
  };
  const Tuples& tuples_of(Set set) const {
    assert(set != Set::pairs);
    return tuples_[static_cast<std::size_t>(set) - 1];
  }

  /// Finds the cells that such a case takes, new ones among them; how many of these there are.
  std::uint32_t find_won(const Observation& observed, double value, std::vector<Cell*>& won);
  std::uint32_t find_won_in_tuples(std::size_t set, const Conditions& conditions, double value,
                                   std::vector<Cell*>& won);
  void take(Cell& cell, EntryId entry);
  void free_if_unused(EntryId id);

  std::vector<Entry> entries_;
  std::vector<EntryId> free_;
  std::vector<Cell> pair_cells_;
  std::vector<std::uint32_t> filled_pairs_;
  std::array<Tuples, kTupleSets> tuples_;
  std::vector<EntryId> newest_;
};

}  // namespace manifuzz
