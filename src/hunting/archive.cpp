#include "hunting/archive.hpp"

#include <algorithm>
#include <span>

namespace manifuzz {
namespace {

constexpr std::size_t kPairs = kConditions * (kConditions - 1) / 2;
constexpr std::size_t kBinsOfPair = static_cast<std::size_t>(kBins) * kBins;

/// So many of the last cases are remembered, at least.
constexpr std::size_t kRemembered = 4096;

/// A cell for each tuple of these labels with a bin of one of these figures.
struct TupleSet {
  std::span<const Condition> labels;
  std::span<const Condition> figures;
};

constexpr std::array kNumbered{Condition::count_a,      Condition::count_b,
                               Condition::corners,      Condition::reference_side,
                               Condition::cuts,         Condition::reference_face,
                               Condition::incident_edge};
constexpr std::array kKind{Condition::count_a, Condition::count_b, Condition::corners,
                           Condition::reference_side, Condition::cuts};
constexpr std::array kCounts{Condition::count_a, Condition::count_b};

constexpr std::array kContact{Condition::depth, Condition::tilt, Condition::slab_margin};
constexpr std::array kContactAndSizes{
    Condition::depth,      Condition::tilt,         Condition::slab_margin, Condition::scale,
    Condition::size_ratio, Condition::radius_ratio, Condition::radius_of_a, Condition::radius_of_b};

/// In the order of Archive::Set, from labels on.
constexpr std::array<TupleSet, Archive::kTupleSets> kSetsOfTuples{
    {{kNumbered, kContact}, {kKind, kContact}, {kCounts, kContactAndSizes}}};

}  // namespace

Archive::Archive() : pair_cells_(kPairs * kBinsOfPair) {}

std::uint32_t Archive::find_won(const Observation& observed, double value,
                                std::vector<Cell*>& won) {
  std::uint32_t new_cells = 0;
  const auto& bins = observed.conditions.all();
  std::size_t begin = 0;
  for (std::size_t i = 0; i < kConditions; ++i) {
    for (std::size_t j = i + 1; j < kConditions; ++j, begin += kBinsOfPair) {
      const std::size_t at = begin + std::size_t{bins[i]} * kBins + bins[j];
      Cell& cell = pair_cells_[at];
      ++cell.visits;
      if (cell.is_filled && cell.value >= value) continue;
      if (!cell.is_filled) {
        ++new_cells;
        filled_pairs_.push_back(static_cast<std::uint32_t>(at));
      }
      won.push_back(&cell);
    }
  }
  for (std::size_t set = 0; set < kTupleSets; ++set) {
    new_cells += find_won_in_tuples(set, observed.conditions, value, won);
  }
  return new_cells;
}

std::uint32_t Archive::find_won_in_tuples(std::size_t set, const Conditions& conditions,
                                          double value, std::vector<Cell*>& won) {
  const auto& [labels, figures] = kSetsOfTuples[set];
  Tuples& tuples = tuples_[set];
  std::uint64_t tuple = 1;
  for (const Condition label : labels) tuple = tuple * kBins + conditions[label];
  std::uint32_t new_cells = 0;
  for (std::size_t k = 0; k < figures.size(); ++k) {
    const std::uint64_t key = (tuple * figures.size() + k) * kBins + conditions[figures[k]];
    const auto place = static_cast<std::uint32_t>(tuples.cells.size());
    const auto [found, is_new] = tuples.places.try_emplace(key, place);
    if (is_new) {
      tuples.cells.emplace_back();
      ++new_cells;
    }
    Cell& cell = tuples.cells[found->second];
    ++cell.visits;
    if (!cell.is_filled || cell.value < value) won.push_back(&cell);
  }
  return new_cells;
}

EntryId Archive::put(const PairCase& pair, const Observation& observed, double value) {
  const Entry entry{pair, observed, value};
  EntryId id = static_cast<EntryId>(entries_.size());
  if (free_.empty()) {
    entries_.push_back(entry);
  } else {
    id = free_.back();
    free_.pop_back();
    entries_[id] = entry;
  }
  if (newest_.size() >= 2 * kRemembered) {
    newest_.erase(newest_.begin(), newest_.end() - kRemembered);
  }
  newest_.push_back(id);
  return id;
}

void Archive::take(Cell& cell, EntryId entry) {
  const Cell before = cell;
  cell.entry = entry;
  cell.value = entries_[entry].value;
  cell.is_filled = true;
  ++entries_[entry].cells;
  if (!before.is_filled) return;
  --entries_[before.entry].cells;
  free_if_unused(before.entry);
}

void Archive::let_go(EntryId id) {
  --entries_[id].holds;
  free_if_unused(id);
}

void Archive::free_if_unused(EntryId id) {
  if (entries_[id].cells == 0 && entries_[id].holds == 0) free_.push_back(id);
}

std::vector<EntryId> Archive::all() const {
  std::vector<EntryId> all;
  for (EntryId id = 0; id < entries_.size(); ++id) {
    if (entries_[id].cells > 0 || entries_[id].holds > 0) all.push_back(id);
  }
  return all;
}

std::vector<EntryId> Archive::newest(std::size_t most) const {
  std::vector<EntryId> newest;
  const std::size_t begin = newest_.size() - std::min(most, newest_.size());
  for (std::size_t i = begin; i < newest_.size(); ++i) {
    if (entries_[newest_[i]].cells > 0) newest.push_back(newest_[i]);
  }
  return newest;
}

}  // namespace manifuzz
