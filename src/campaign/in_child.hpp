#pragma once

#include <atomic>
#include <functional>
#include <stdexcept>

#include "judging/judge.hpp"
#include "process/process.hpp"

namespace manifuzz {

/// A case that takes longer than this has hung: 5 s, and what those in processes of their own may
/// take, which see to it themselves.
inline double case_seconds_max(const Collider& subject, const Collider& oracle) {
  return 5 + subject.seconds_max + oracle.seconds_max;
}

enum class Ending { well, crashed, hung, interrupted };

/// Runs `body` in a child process for as long as `pulse` moves at least once in `seconds_max`.
Ending run_in_child(const std::function<void()>& body, const std::atomic<int>& pulse,
                    double seconds_max, Interruption& interruption);

/// Thrown where somebody asked to stop before there was an answer.
struct Interrupted : std::runtime_error {
  Interrupted() : std::runtime_error("interrupted before there was an answer") {}
};

/// `judge` on what the two answer in a child process: a collider that dies or hangs is a verdict.
/// Throws Interrupted.
Judgement judge_in_child(const PairCase& pair, const Collider& subject, const Collider& oracle,
                         Interruption& interruption);

/// What the collider answers, completed; asked in a child process first where it could take this
/// one along. Throws Interrupted.
Answer ask_in_child(const Collider& collider, const PairCase& pair, Interruption& interruption);

}  // namespace manifuzz
