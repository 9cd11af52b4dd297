#pragma once

#include <stdexcept>

#include "judging/judge.hpp"
#include "process/pool.hpp"

namespace manifuzz {

/// A case that takes longer than this has hung: 5 s, and what those in processes of their own may
/// take, which see to it themselves.
inline double case_seconds_max(const Collider& subject, const Collider& oracle) {
  return 5 + subject.seconds_max + oracle.seconds_max;
}

/// Thrown where work was stopped before there was an answer.
struct Interrupted : std::runtime_error {
  Interrupted() : std::runtime_error("interrupted before there was an answer") {}
};

/// What a child's end, crashed or timed out, makes of the answer that it was to give.
Lost lost_by(Ending ending);
Bucket bucket_of_lost(Ending ending, Fault at_work);

/// `judge` on what the two answer in a child process: a collider that dies or hangs is a verdict.
/// Throws Interrupted.
Judgement judge_in_child(const PairCase& pair, const Collider& subject, const Collider& oracle,
                         Interruption& interruption);

/// What the collider answers in a child process, asked once and completed; Lost where it dies or
/// hangs. Throws Interrupted.
Answer ask_in_child(const Collider& collider, const PairCase& pair, Interruption& interruption);

}  // namespace manifuzz
