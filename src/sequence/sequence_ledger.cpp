#include "sequence/sequence_ledger.hpp"

#include <array>

#include "sequence/kept_faults.hpp"

namespace manifuzz {
namespace {

/// The entries on this repository's own keepers.
constexpr std::array kOwn{
    SequenceEntry{{.id = "cached-bullet-world-normal",
                   .collider = "cached-bullet",
                   .description = kWorldNormal,
                   .source = kWorldNormalSource},
                  normal_of_the_world},
    SequenceEntry{{.id = "cached-bullet-slot-by-areas",
                   .collider = "cached-bullet",
                   .description = kAreas,
                   .source = kAreasSource},
                  slot_by_areas},
};

const LedgerEntry* find_in(std::span<const SequenceEntry> entries, std::string_view keeper,
                           const FrameView& view, const FrameJudgement& judgement) {
  for (const SequenceEntry& known : entries) {
    if (known.entry.collider == keeper && known.explains(view, judgement)) return &known.entry;
  }
  return nullptr;
}

}  // namespace

const LedgerEntry* find_sequence_explanation(const FrameView& view,
                                             const FrameJudgement& judgement) {
  // What keeps the points of another collider is named after both.
  const std::string_view name = view.subject.declaration.name;
  const std::string_view keeper = name.substr(0, name.find('+'));
  for (const std::span<const SequenceEntry> of_engine : built_sequence_ledgers()) {
    const LedgerEntry* const found = find_in(of_engine, keeper, view, judgement);
    if (found != nullptr) return found;
  }
  return find_in(kOwn, keeper, view, judgement);
}

}  // namespace manifuzz
