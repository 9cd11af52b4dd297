#pragma once

#include <functional>
#include <stdexcept>

#include "campaign/trial.hpp"
#include "collider/collider.hpp"
#include "corpus/shrink.hpp"
#include "judging/judge.hpp"
#include "process/interruption.hpp"
#include "process/pool.hpp"

namespace manifuzz {

/// What a collider in this process or a fork of it may take over a case: then it has hung.
inline constexpr double kCaseSeconds = 5;

/// The limit for a case put to both colliders; those in processes of their own enforce theirs.
inline double case_seconds_max(const Collider& subject, const Collider& oracle) {
  return kCaseSeconds + subject.seconds_max + oracle.seconds_max;
}

/// Thrown where work was stopped before there was an answer.
struct Interrupted : std::runtime_error {
  Interrupted() : std::runtime_error("interrupted before there was an answer") {}
};

/// Does as much of the work as there is time for.
void unless_interrupted(const std::function<void()>& work);

/// What a child's end, crashed or timed out, makes of the answer that it was to give.
Lost lost_by(Ending ending);
Bucket bucket_of_lost(Ending ending, Fault at_work);

/// The collider in a process of its own, which runs from case to case and is begun anew where it
/// dies or hangs; as it is where it has one already.
Collider hosted(const Collider& collider);

/// `judge` on what the two answer in a child process: a collider that dies or hangs is a verdict.
/// Throws Interrupted.
Judgement judge_in_child(const PairCase& pair, const Collider& subject, const Collider& oracle,
                         Interruption& interruption);

/// The judgement where a child ended before it had one, with one of the two at work: that it was
/// lost, or what the ledger knows of that. Throws Interrupted.
Judgement judge_lost(const PairCase& pair, const Collider& subject, const Collider& oracle,
                     const Loss& loss, Interruption& interruption);

/// What the collider answers in a child process, asked once and completed; Lost where it dies or
/// hangs. Throws Interrupted.
Answer ask_in_child(const Collider& collider, const PairCase& pair, Interruption& interruption);

/// The smallest case that is the same finding. Colliders may die; those in processes of their own
/// are not started anew for it. Ends early, with the smallest so far, at the deadline, and at the
/// first signal from now on. Throws Interrupted where it had not begun.
Shrunk shrink_finding(const PairCase& pair, const Collider& subject, const Collider& oracle,
                      Interruption& interruption, const Deadline& deadline = {});

/// Asks both colliders for the cells of the grid, so too: a cell on which one of them dies is
/// judged as crashed. Begins with the case itself and goes on evenly spread, so that the cells
/// asked are a fair sample where it ends early: after `cells_max` cells, after as many crashes as
/// take no longer than that, after the first hang, once answers that were lost took some seconds,
/// or when interrupted.
Neighbourhood ask_neighbourhood(const PairCase& pair, const Collider& subject,
                                const Collider& oracle, const Grid& grid, int cells_max,
                                Interruption& interruption);

}  // namespace manifuzz
