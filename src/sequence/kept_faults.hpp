#pragma once

#include <string_view>

#include "sequence/frame_judge.hpp"

namespace manifuzz {

// Faults of keepers that ledgers over frames share.

/// The point of which a fault is, in the frame that it is of.
const KeptPoint& point_of(const FrameView& view, const FrameJudgement& judgement);

/// The normal stays as it was in the world while both bodies turn: what is wrong is the normal, or
/// that the point is taken for too stale along it, or not so.
bool normal_of_the_world(const FrameView& view, const FrameJudgement& judgement);

/// A point too many takes the slot of an old one as areas between four have it, and on a line all
/// areas are 0.
bool slot_by_areas(const FrameView& view, const FrameJudgement& judgement);

/// The answer as a collider gives it that keeps nothing: its entries in the ledger explain what is
/// detected.
bool detected_by(std::string_view collider, const FrameView& view, const FrameJudgement& judgement);

}  // namespace manifuzz
