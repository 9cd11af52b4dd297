#include "campaign/in_child.hpp"

#include <array>
#include <atomic>
#include <optional>

#include "judging/completed.hpp"
#include "process/shared_memory.hpp"

namespace manifuzz {
namespace {

/// What a child that judges leaves behind. The ledger entry's address holds in its parent too.
struct JudgementSlot {
  std::atomic<Fault> at_work{Fault::none};
  Judgement judgement;
};

/// An answer without pointers, for shared memory.
struct AnswerSlot {
  std::size_t kind = 0;  ///< its place among the kinds of an Answer
  PartialManifold manifold;
  Lost::How how = Lost::How::crashed;
  SharedText<512> why;

  void put(const Answer& answer) {
    kind = answer.index();
    if (const auto* const whole = std::get_if<Manifold<double>>(&answer)) {
      manifold.manifold = *whole;
    } else if (const auto* const partial = std::get_if<PartialManifold>(&answer)) {
      manifold = *partial;
    } else if (const auto* const lost = std::get_if<Lost>(&answer)) {
      how = lost->how;
      why.set(lost->why);
    } else {
      why.set(std::get<Unsupported>(answer).why);
    }
  }

  Answer answer() const {
    const std::array<Answer, std::variant_size_v<Answer>> kinds{
        manifold.manifold, Unsupported{why.str()}, manifold, Lost{how, why.str()}};
    return kinds[kind];
  }
};

/// What one in a process of its own answers.
Answer ask_isolated(const Collider& collider, const PairCase& pair, Interruption& interruption) {
  Answer answer;
  const auto go_on = [&] { return !interruption.is_stopped(); };
  if (collider.collide_many({&pair, 1}, {&answer, 1}, go_on) == 0) throw Interrupted();
  return answer;
}

}  // namespace

Lost lost_by(Ending ending) {
  if (ending == Ending::crashed) return {Lost::How::crashed, "crashed"};
  return {Lost::How::timed_out, "timed out"};
}

Bucket bucket_of_lost(Ending ending, Fault at_work) {
  return bucket_of_lost(ending == Ending::crashed ? Verdict::crashed : Verdict::timed_out, at_work);
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
  const Shared<JudgementSlot> slot;
  const auto body = [&] {
    slot->at_work = Fault::subject;
    const Answer of_subject = subject_here ? *subject_here : subject.collide(pair);
    slot->at_work = Fault::oracle;
    const Answer of_oracle = oracle_here ? *oracle_here : oracle.collide(pair);
    slot->at_work = Fault::none;
    slot->judgement =
        judge(pair, {subject.declaration, of_subject}, {oracle.declaration, of_oracle});
  };
  const Ending ending = run_in_child(body, case_seconds_max(subject, oracle), interruption);
  if (ending == Ending::stopped) throw Interrupted();
  if (ending == Ending::done) return slot->judgement;
  return {.bucket = bucket_of_lost(ending, slot->at_work)};
}

Answer ask_in_child(const Collider& collider, const PairCase& pair, Interruption& interruption) {
  if (collider.is_isolated()) {
    return whole(ask_isolated(collider, pair, interruption), pair, collider.declaration);
  }
  const Shared<AnswerSlot> slot;
  const Ending ending = run_in_child([&] { slot->put(collider.collide(pair)); },
                                     case_seconds_max(collider, collider), interruption);
  if (ending == Ending::stopped) throw Interrupted();
  if (ending != Ending::done) return lost_by(ending);
  return whole(slot->answer(), pair, collider.declaration);
}

}  // namespace manifuzz
