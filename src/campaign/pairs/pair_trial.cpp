#include "campaign/pairs/pair_trial.hpp"

#include <fmt/format.h>

#include "campaign/in_child.hpp"
#include "campaign/pairs/recorded_case.hpp"

namespace manifuzz {
namespace {

const PairCase& pair_in(const AnyCase& any) {
  return std::get<PairCase>(any);
}

class PairTrial : public Trial {
 public:
  PairTrial(const Collider& subject, const Collider& oracle) : Trial(subject, oracle) {}

  Judgement judge(const AnyCase& any, Interruption& interruption) const override {
    return judge_in_child(pair_in(any), subject(), oracle(), interruption);
  }

  Judgement judge_lost(const AnyCase& any, const Loss& loss,
                       Interruption& interruption) const override {
    return manifuzz::judge_lost(pair_in(any), subject(), oracle(), loss, interruption);
  }

  Smallest shrink(const AnyCase& any, Interruption& interruption,
                  const Deadline& deadline) const override {
    const Shrunk shrunk = shrink_finding(pair_in(any), subject(), oracle(), interruption, deadline);
    return {shrunk.pair, shrunk.complete};
  }

  std::string why_unshrinkable(const Judgement& judgement, bool) const override {
    const std::string& one = subject().declaration.name;
    const std::string& other = oracle().declaration.name;
    if (judgement.bucket.verdict == Verdict::agree) {
      return fmt::format("{} and {} agree on it; a case on which they differ is expected", one,
                         other);
    }
    if (judgement.bucket.verdict != Verdict::unsupported) return "";
    return fmt::format("{} or {} cannot take it; a case that both take is expected", one, other);
  }

  CorpusCase recorded(const AnyCase& any, const Judgement& judgement, Interruption& interruption,
                      const Deadline& severity_until) const override {
    return recorded_case(pair_in(any), judgement, subject(), oracle(), interruption,
                         severity_until);
  }

  CorpusCase unasked(const AnyCase& any, const Judgement& judgement) const override {
    return unasked_case(pair_in(any), judgement, subject(), oracle());
  }
};

}  // namespace

std::shared_ptr<const Trial> trial_of_pairs(const Collider& subject, const Collider& oracle) {
  return std::make_shared<PairTrial>(subject, oracle);
}

TrialOf trials_of_pairs(const std::shared_ptr<NamedColliders>& colliders) {
  return [colliders](const CorpusCase& known) -> std::shared_ptr<const Trial> {
    const Collider* const subject = colliders->subject_of(known);
    const Collider* const oracle = colliders->oracle_of(known);
    if (subject == nullptr || oracle == nullptr) return nullptr;
    return trial_of_pairs(*subject, *oracle);
  };
}

}  // namespace manifuzz
