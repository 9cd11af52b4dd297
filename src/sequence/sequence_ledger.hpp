#pragma once

#include <span>
#include <vector>

#include "sequence/frame_judge.hpp"

namespace manifuzz {

/// A known deviation of a collider that keeps points. The entry is as in the ledger of pair cases,
/// but for what it looks at: one fault of a frame.
struct SequenceEntry {
  LedgerEntry entry;
  bool (*explains)(const FrameView& view, const FrameJudgement& judgement) = nullptr;
};

/// What an engine's sources say of such an entry, as a `LedgerRow` does of others.
struct SequenceRow {
  std::string_view cause;
  bool (*explains)(const FrameView& view, const FrameJudgement& judgement) = nullptr;
};

/// Rows of a collider that keeps points, the first that explains before others.
struct SequenceRows {
  std::string_view collider;
  std::span<const SequenceRow> rows;
};

/// The entries over frames of each engine that a program is built with, in the order of the
/// engines; defined where `built_ledger` is.
std::vector<SequenceEntry> built_sequence_ledger();

/// The first entry that explains what this collider did in a frame, or nullptr.
const LedgerEntry* find_sequence_explanation(const FrameView& view,
                                             const FrameJudgement& judgement);

}  // namespace manifuzz
