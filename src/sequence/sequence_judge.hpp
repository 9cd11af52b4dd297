#pragma once

#include <optional>
#include <span>
#include <vector>

#include "collider/sequence_collider.hpp"
#include "geometry/sequence.hpp"
#include "judging/bucket.hpp"
#include "judging/compare.hpp"
#include "judging/judge.hpp"
#include "judging/ledger.hpp"

namespace manifuzz {

/// What is wrong in one frame; kind `none` where nothing is, or float cannot say.
struct FrameJudgement {
  Kind kind = Kind::none;
  /// Which of the frame's points, if it is one; of `extent` one of the frame before, that is gone.
  std::optional<std::size_t> point{};
  double magnitude = 0;  ///< as a share of the size; of directions their difference
  double bound = 0;      ///< within which it would be right, likewise
  bool is_ill_posed = false;
  const LedgerEntry* explanation = nullptr;  ///< of what is wrong
};

/// The verdict on a whole sequence: that of the most serious frame, the first of equals; what
/// nobody explains comes before what the ledger does.
struct SequenceJudgement {
  Bucket bucket{};
  double magnitude = 0;
  std::size_t frame = 0;               ///< the one that decides
  std::vector<FrameJudgement> frames;  ///< of all that were judged
  const LedgerEntry* explanation = nullptr;
};

/// Judges answers to a sequence, one for each frame, or fewer where the last of them is lost.
SequenceJudgement judge_sequence(const Sequence& sequence, const SequenceCollider& subject,
                                 std::span<const KeptAnswer> answers);

/// Whether a collider may be asked about a sequence, by what it declares of shapes. Sharp polygons
/// have no radius for one that takes none.
bool takes(const SequenceCollider& subject, const Sequence& sequence);

/// What the subject answers, frame by frame, up to the first that is lost or unsupported; it is not
/// asked about shapes that it does not take.
std::vector<KeptAnswer> ask_sequence(const SequenceCollider& subject, const Sequence& sequence);

}  // namespace manifuzz
