#pragma once

#include <span>

#include "sequence/frame_judge.hpp"

namespace manifuzz {

/// A known deviation of a collider that keeps points. The entry is as in the ledger of pair cases,
/// but for what it looks at: one fault of a frame.
struct SequenceEntry {
  LedgerEntry entry;
  bool (*explains)(const FrameView& view, const FrameJudgement& judgement) = nullptr;
};

/// Every known deviation over frames. An entry is added here, and nowhere else.
std::span<const SequenceEntry> sequence_ledger();

/// The first entry that explains what this collider did in a frame, or nullptr.
const LedgerEntry* find_sequence_explanation(const FrameView& view,
                                             const FrameJudgement& judgement);

}  // namespace manifuzz
