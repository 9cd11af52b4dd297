#pragma once

#include "collider/sequence_collider.hpp"

namespace manifuzz::test {

/// What a keeper does wrong; each shows in a kind of its own.
enum class Mistake {
  none,
  keeps_nothing,    ///< no mistake: the detection of each frame alone
  stale_normal,     ///< its normals stay as they were in the world
  past_gap,         ///< points are kept whatever their gap
  past_drift,       ///< points are kept however far they slid
  past_turn,        ///< points are kept however far B turned against A
  stale_depth,      ///< depths stay as they were at birth
  drops_deepest,    ///< now and then the deepest point that was kept goes
  drops_end,        ///< now and then the point that is farthest to a side goes
  false_birth,      ///< what is kept claims to be detected anew
  anchor_aside,     ///< the anchor on A is beside the place
  both_aside,       ///< both anchors are, past the ends of faces
  moves_anchors,    ///< anchors of what is kept are moved to where bodies touch now
  detects_no_more,  ///< after the first frame nothing is detected
  shares_ids,       ///< all points have one id
  born_before,      ///< points claim a birth in the frame before
  too_many,         ///< points are given twice
};

/// Keeps points of gjk64 as `cached64` does, but for one mistake.
SequenceCollider keeper_with(Mistake mistake);

}  // namespace manifuzz::test
