#include "campaign/in_child.hpp"

#include <chrono>
#include <optional>
#include <sys/wait.h>

#include "judging/completed.hpp"

namespace manifuzz {
namespace {

using Clock = std::chrono::steady_clock;

/// What a child leaves behind. The ledger entry's address holds in its parent too.
struct Slot {
  std::atomic<Fault> at_work{Fault::none};
  std::atomic<int> pulse{0};
  Judgement judgement;
};

/// What one in a process of its own answers, unless somebody asks to stop before: Interrupted.
Answer ask_isolated(const Collider& collider, const PairCase& pair, Interruption& interruption) {
  Answer answer;
  const auto go_on = [&] { return !interruption.requested(); };
  if (collider.collide_many({&pair, 1}, {&answer, 1}, go_on) == 0) throw Interrupted();
  return answer;
}

}  // namespace

Ending run_in_child(const std::function<void()>& body, const std::atomic<int>& pulse,
                    double seconds_max, Interruption& interruption) {
  const pid_t child = spawn(body);
  int seen = pulse;
  Clock::time_point seen_at = Clock::now();
  for (;;) {
    int status = 0;
    if (waitpid(child, &status, WNOHANG) == child) {
      return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? Ending::well : Ending::crashed;
    }
    if (pulse != seen) {
      seen = pulse;
      seen_at = Clock::now();
    }
    if (interruption.requested()) {
      kill_and_wait(child);
      return Ending::interrupted;
    }
    if (std::chrono::duration<double>(Clock::now() - seen_at).count() > seconds_max) {
      kill_and_wait(child);
      return Ending::hung;
    }
    interruption.wait(0.1);
  }
}

Judgement judge_in_child(const PairCase& pair, const Collider& subject, const Collider& oracle,
                         Interruption& interruption) {
  // Those in a process of their own are asked from here, where they run already.
  const auto asked_here = [&](const Collider& collider) {
    return collider.is_isolated() ? std::optional(ask_isolated(collider, pair, interruption))
                                  : std::nullopt;
  };
  const std::optional<Answer> subject_here = asked_here(subject);
  const std::optional<Answer> oracle_here = asked_here(oracle);
  if (subject_here && oracle_here) {
    return judge(pair, {subject.declaration, *subject_here}, {oracle.declaration, *oracle_here});
  }
  const Shared<Slot> slot;
  const auto body = [&] {
    slot->at_work = Fault::subject;
    const Answer of_subject = subject_here ? *subject_here : subject.collide(pair);
    slot->at_work = Fault::oracle;
    const Answer of_oracle = oracle_here ? *oracle_here : oracle.collide(pair);
    slot->at_work = Fault::none;
    slot->judgement =
        judge(pair, {subject.declaration, of_subject}, {oracle.declaration, of_oracle});
  };
  switch (run_in_child(body, slot->pulse, case_seconds_max(subject, oracle), interruption)) {
    case Ending::crashed:
      return {.bucket = bucket_of_lost(Verdict::crashed, slot->at_work)};
    case Ending::hung:
      return {.bucket = bucket_of_lost(Verdict::timed_out, slot->at_work)};
    case Ending::interrupted:
      throw Interrupted();
    case Ending::well:
      break;
  }
  return slot->judgement;
}

Answer ask_in_child(const Collider& collider, const PairCase& pair, Interruption& interruption) {
  if (collider.is_isolated()) {
    return whole(ask_isolated(collider, pair, interruption), pair, collider.declaration);
  }
  const std::atomic<int> pulse{0};
  switch (run_in_child([&] { collider.collide(pair); }, pulse, case_seconds_max(collider, collider),
                       interruption)) {
    case Ending::crashed:
      return Lost{Lost::How::crashed, "crashed"};
    case Ending::hung:
      return Lost{Lost::How::timed_out, "timed out"};
    case Ending::interrupted:
      throw Interrupted();
    case Ending::well:
      break;
  }
  return ask(collider, pair);
}

}  // namespace manifuzz
