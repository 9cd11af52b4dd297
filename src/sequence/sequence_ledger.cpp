#include "sequence/sequence_ledger.hpp"

#include <algorithm>

#include "sequence/kept_faults.hpp"

namespace manifuzz {
namespace {

/// The engines' entries, and those on this repository's own keepers.
std::span<const SequenceEntry> sequence_ledger() {
  static const std::vector<SequenceEntry> all = [] {
    std::vector<SequenceEntry> entries = built_sequence_ledger();
    entries.push_back({{.id = "cached-bullet-world-normal",
                        .collider = "cached-bullet",
                        .description = "the normal stays in the world while both bodies turn",
                        .source = "Bullet, btPersistentManifold.cpp, refreshContactPoints: "
                                  "m_normalWorldOnB is never turned"},
                       normal_of_the_world});
    entries.push_back({{.id = "cached-bullet-slot-by-areas",
                        .collider = "cached-bullet",
                        .description = "a fifth point takes the slot of one that is deepest or at "
                                       "an end: areas on a line are 0",
                        .source = "Bullet, btPersistentManifold.cpp, sortCachedPoints"},
                       slot_by_areas});
    return entries;
  }();
  return all;
}

/// Filled before anything is forked: a child says by an address which entry explains a fault.
[[maybe_unused]] const bool is_sequence_ledger_filled = !sequence_ledger().empty();

}  // namespace

const LedgerEntry* find_sequence_explanation(const FrameView& view,
                                             const FrameJudgement& judgement) {
  // What keeps the points of another collider is named after both.
  const std::string_view name = view.subject.declaration.name;
  const std::string_view keeper = name.substr(0, name.find('+'));
  const auto explains = [&](const SequenceEntry& known) {
    return known.entry.collider == keeper && known.explains(view, judgement);
  };
  const auto found = std::ranges::find_if(sequence_ledger(), explains);
  return found == sequence_ledger().end() ? nullptr : &found->entry;
}

}  // namespace manifuzz
