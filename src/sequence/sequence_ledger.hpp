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

/// The ledger over frames of each engine that a program is built with, in the order of the engines;
/// defined where `built_ledgers` is.
std::vector<std::span<const SequenceEntry>> built_sequence_ledgers();

/// The first entry that explains what this collider did in a frame, or nullptr.
const LedgerEntry* find_sequence_explanation(const FrameView& view,
                                             const FrameJudgement& judgement);

}  // namespace manifuzz
