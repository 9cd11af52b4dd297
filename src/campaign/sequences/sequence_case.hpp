#pragma once

#include <functional>
#include <vector>

#include "campaign/plan.hpp"
#include "collider/sequence_collider.hpp"
#include "corpus/shrink_sequence.hpp"
#include "judging/judge.hpp"
#include "process/interruption.hpp"
#include "sequence/sequence_judge.hpp"

namespace manifuzz {

// One sequence at a time: asked, judged, shrunk.

/// A sequence, what a collider that keeps points answers to it, and the verdict.
struct JudgedSequence {
  CorpusCase given;
  SequenceCollider subject;
  std::vector<KeptAnswer> answers;  ///< up to the first that is lost or unsupported
  SequenceJudgement judgement;
};

/// A copy of the collider that calls `on_frame` before each frame that it is asked.
SequenceCollider watched(const SequenceCollider& subject, const std::function<void()>& on_frame);

/// The verdict as that on any case.
Judgement counted(const SequenceJudgement& judgement);

/// What the collider answers in a child process, frame by frame; the last one is Lost where it dies
/// or hangs. Throws Interrupted.
std::vector<KeptAnswer> ask_in_child(const SequenceCollider& subject, const Sequence& sequence,
                                     Interruption& interruption);

/// The collider is asked so. Throws Interrupted.
JudgedSequence judged_sequence(const CorpusCase& given, const SequenceCollider& subject,
                               Interruption& interruption);

/// The verdict alone. Throws Interrupted.
SequenceJudgement judge_in_child(const Sequence& sequence, const SequenceCollider& subject,
                                 Interruption& interruption);

/// The smallest sequence that is the same finding, with bodies that touch in the frame that decides
/// if they did; otherwise as `shrink_finding` of a pair case.
ShrunkSequence shrink_finding(const Sequence& sequence, const SequenceCollider& subject,
                              Interruption& interruption, const Deadline& deadline = {});

}  // namespace manifuzz
