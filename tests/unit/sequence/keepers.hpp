#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>

#include "collider/sequence_collider.hpp"
#include "geometry/sequence.hpp"
#include "judging/bucket.hpp"

namespace manifuzz::test {

/// What a keeper does wrong; each shows in a kind of its own.
enum class Mistake {
  none,
  keeps_nothing,    ///< no mistake: the detection of each frame alone
  both_ends,        ///< no mistake: of polygons both ends of clips are detected
  one_depth,        ///< the shallower end of a clip has the depth of the other
  end_aside,        ///< the shallower end of a clip is beside its place
  new_beside_old,   ///< a new point takes no old one's place
  wrong_carrier,    ///< a normal travels with the other body than it says
  stale_normal,     ///< its normals stay as they were in the world
  past_gap,         ///< points are kept whatever their gap
  past_drift,       ///< points are kept however far they slid
  past_turn,        ///< points are kept however far B turned against A
  stale_depth,      ///< depths stay as they were at birth
  drops_deepest,    ///< now and then the deepest point that was kept goes
  drops_end,        ///< now and then the point that is farthest to a side goes
  false_birth,      ///< what is kept claims to be detected anew
  anchor_aside,     ///< the anchor on B is beside that on A
  both_aside,       ///< both anchors are, past the ends of faces
  moves_anchors,    ///< anchors of what is kept are moved to where bodies touch now
  detects_no_more,  ///< after the first frame nothing is detected
  shares_ids,       ///< all points have one id
  born_before,      ///< points claim a birth in the frame before
  too_many,         ///< more points are given than are declared
};

/// Keeps points of gjk64 as `cached64` does, but for one mistake.
SequenceCollider keeper_with(Mistake mistake);

/// A judge of sequences, as it stands or with a bug in it.
using JudgeOfSequence = Bucket (*)(const Sequence& sequence, const SequenceCollider& subject,
                                   std::span<const KeptAnswer> answers);

/// In words, what a judge makes of keepers, right and wrong, that it should not; none where it says
/// of each mistake what it is, in as many sequences as show it.
std::optional<std::string> complaint_about(JudgeOfSequence judge);

}  // namespace manifuzz::test
