#include "campaign/in_child.hpp"

#include <atomic>
#include <optional>

#include "judging/completed.hpp"
#include "process/pool.hpp"
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
  enum class Kind { manifold, partial, unsupported, lost };
  Kind kind = Kind::manifold;
  PartialManifold manifold;
  Lost::How how = Lost::How::crashed;
  SharedText<512> why;

  void put(const Answer& answer) {
    if (const auto* const whole = std::get_if<Manifold<double>>(&answer)) {
      kind = Kind::manifold;
      manifold.manifold = *whole;
    } else if (const auto* const partial = std::get_if<PartialManifold>(&answer)) {
      kind = Kind::partial;
      manifold = *partial;
    } else if (const auto* const unsupported = std::get_if<Unsupported>(&answer)) {
      kind = Kind::unsupported;
      why.set(unsupported->why);
    } else {
      kind = Kind::lost;
      how = std::get<Lost>(answer).how;
      why.set(std::get<Lost>(answer).why);
    }
  }

  Answer answer() const {
    switch (kind) {
      case Kind::manifold:
        return manifold.manifold;
      case Kind::partial:
        return manifold;
      case Kind::unsupported:
        return Unsupported{why.str()};
      default:
        return Lost{how, why.str()};
    }
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
  switch (run_in_child(body, case_seconds_max(subject, oracle), interruption)) {
    case Ending::crashed:
      return {.bucket = bucket_of_lost(Verdict::crashed, slot->at_work)};
    case Ending::timed_out:
      return {.bucket = bucket_of_lost(Verdict::timed_out, slot->at_work)};
    case Ending::stopped:
      throw Interrupted();
    default:
      return slot->judgement;
  }
}

Answer ask_in_child(const Collider& collider, const PairCase& pair, Interruption& interruption) {
  if (collider.is_isolated()) {
    return whole(ask_isolated(collider, pair, interruption), pair, collider.declaration);
  }
  const Shared<AnswerSlot> slot;
  switch (run_in_child([&] { slot->put(collider.collide(pair)); },
                       case_seconds_max(collider, collider), interruption)) {
    case Ending::crashed:
      return Lost{Lost::How::crashed, "crashed"};
    case Ending::timed_out:
      return Lost{Lost::How::timed_out, "timed out"};
    case Ending::stopped:
      throw Interrupted();
    default:
      return whole(slot->answer(), pair, collider.declaration);
  }
}

}  // namespace manifuzz
