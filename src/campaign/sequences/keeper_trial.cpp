#include "campaign/sequences/keeper_trial.hpp"

#include <map>

#include <fmt/format.h>

#include "base/text.hpp"
#include "campaign/in_child.hpp"
#include "campaign/sequences/sequence_case.hpp"

namespace manifuzz {
namespace {

Collider as_declared(const SequenceCollider& keeper) {
  Collider declared;
  declared.declaration = keeper.declaration;
  return declared;
}

std::string note_of(const Judgement& judgement, const std::string& subject, std::size_t frames) {
  const LedgerEntry* const entry = judgement.explanation;
  if (entry != nullptr) return fmt::format("{}: {}.", entry->id, entry->description);
  const Bucket& bucket = judgement.bucket;
  const std::string where =
      !judgement.frame ? ""
      : frames == 1    ? " in its one frame"
                       : fmt::format(" in frame {} of 0 to {}", *judgement.frame, frames - 1);
  return fmt::format("{}: {} ({}){}.", subject, to_string(bucket.verdict),
                     name_of(bucket.kind, kKindNames), where);
}

}  // namespace

KeeperTrial::KeeperTrial(const SequenceCollider& keeper)
    : Trial(as_declared(keeper), {}), keeper_(keeper) {}

Judgement KeeperTrial::judge(const AnyCase& any, Interruption& interruption) const {
  return counted(judge_in_child(std::get<Sequence>(any), keeper_, interruption));
}

Judgement KeeperTrial::judge_lost(const AnyCase&, const Loss& loss, Interruption&) const {
  return {.bucket = bucket_of_lost(loss.ending, loss.at_work)};
}

Smallest KeeperTrial::shrink(const AnyCase& any, Interruption& interruption,
                             const Deadline& deadline) const {
  const ShrunkSequence shrunk =
      shrink_finding(std::get<Sequence>(any), keeper_, interruption, deadline);
  return {shrunk.sequence, shrunk.complete};
}

std::string KeeperTrial::why_unshrinkable(const Judgement& judgement, bool was_begun) const {
  const Bucket& bucket = judgement.bucket;
  if (bucket.fault != Fault::none || was_begun) return "";
  return fmt::format("{} is {} on it; a sequence on which it is wrong is expected",
                     keeper_.declaration.name,
                     bucket.verdict == Verdict::agree ? "right" : to_string(bucket.verdict));
}

CorpusCase KeeperTrial::recorded(const AnyCase& any, const Judgement& judgement, Interruption&,
                                 const Deadline&) const {
  return unasked(any, judgement);
}

CorpusCase KeeperTrial::unasked(const AnyCase& any, const Judgement& judgement) const {
  CorpusCase recorded{.any = any};
  Expectation& expect = recorded.expect.emplace();
  expect.subject = keeper_.declaration.name;
  expect.verdict = to_string(judgement.bucket.verdict);
  expect.bucket = to_string(judgement.bucket);
  if (judgement.bucket.verdict != Verdict::agree) expect.magnitude = judgement.magnitude;
  recorded.note = note_of(judgement, expect.subject, frames_in(any));
  return recorded;
}

TrialOf trials_of_keepers(const FindKeeper& find, const std::optional<SequenceCollider>& given) {
  using Made = std::shared_ptr<const KeeperTrial>;
  const auto trial_of = [](const std::optional<SequenceCollider>& keeper) {
    return keeper ? std::make_shared<const KeeperTrial>(*keeper) : nullptr;
  };
  return [find, trial_of, one = trial_of(given),
          made = std::map<std::string, Made>()](const CorpusCase& known) mutable -> Made {
    if (one) return one;
    const bool names_one = known.expect && !known.expect->subject.empty();
    const std::string name = names_one ? known.expect->subject : kUsualKeeper;
    auto of_name = made.find(name);
    if (of_name == made.end()) of_name = made.emplace(name, trial_of(find(name))).first;
    return of_name->second;
  };
}

}  // namespace manifuzz
