#include "campaign/sequences/replay_sequence.hpp"

#include "campaign/in_child.hpp"
#include "campaign/sequences/sequence_case.hpp"
#include "campaign/sequences/sequence_plan.hpp"

namespace manifuzz {
namespace {

std::optional<NamedKeepers::Keeper> keeper_of(const std::optional<SequenceCollider>& collider) {
  if (!collider) return std::nullopt;
  return NamedKeepers::Keeper{*collider, as_declared(*collider)};
}

}  // namespace

NamedKeepers::NamedKeepers(Find find, const std::optional<SequenceCollider>& given)
    : find_(std::move(find)), given_(keeper_of(given)) {}

const NamedKeepers::Keeper* NamedKeepers::subject_of(const CorpusCase& known) {
  if (given_) return &*given_;
  const bool names_one = known.expect && !known.expect->subject.empty();
  const std::string name = names_one ? known.expect->subject : kUsualKeeper;
  auto made = known_.find(name);
  if (made == known_.end()) made = known_.emplace(name, keeper_of(find_(name))).first;
  return made->second ? &*made->second : nullptr;
}

ReplayRun replay_sequences(const std::vector<CorpusCase>& sequences, NamedKeepers& keepers,
                           const Known& known, Interruption& interruption) {
  static const Collider oracle = no_oracle();
  return replay_all(
      sequences, interruption, [&](const CorpusCase& recorded) -> std::optional<ReplayedCase> {
        const NamedKeepers::Keeper* const subject = keepers.subject_of(recorded);
        if (subject == nullptr) return std::nullopt;
        const Collider& declared = subject->declared;
        if (!subject->asked.begin) {
          return ReplayedCase{&recorded,
                              {.expected = "", .got = "", .is_unsupported = true},
                              0,
                              &declared,
                              &oracle};
        }
        const SequenceJudgement judgement =
            judge_in_child(recorded.sequence(), subject->asked, interruption);
        return ReplayedCase{&recorded,
                            replayed(recorded, counted(judgement), declared, oracle, known), 0,
                            &declared, &oracle};
      });
}

}  // namespace manifuzz
