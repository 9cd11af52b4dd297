#pragma once

#include "campaign/trial.hpp"
#include "collider/sequence_collider.hpp"

namespace manifuzz {

/// A collider that keeps points, which is asked about sequences; the judge alone says whether it is
/// right.
class KeeperTrial : public Trial {
 public:
  explicit KeeperTrial(const SequenceCollider& keeper);

  const SequenceCollider& keeper() const { return keeper_; }

  bool is_there() const override { return keeper_.begin != nullptr; }
  Judgement judge(const AnyCase& any, Interruption& interruption) const override;
  Judgement judge_lost(const AnyCase& any, const Loss& loss,
                       Interruption& interruption) const override;
  Smallest shrink(const AnyCase& any, Interruption& interruption,
                  const Deadline& deadline) const override;
  std::string why_unshrinkable(const Judgement& judgement, bool was_begun) const override;
  CorpusCase recorded(const AnyCase& any, const Judgement& judgement, Interruption& interruption,
                      const Deadline& severity_until) const override;
  CorpusCase unasked(const AnyCase& any, const Judgement& judgement) const override;

 private:
  SequenceCollider keeper_;
};

/// Who is asked about a sequence that names nobody.
inline constexpr const char* kUsualKeeper = "cached";

/// Makes the collider of that name, or nothing; where one of that name is known and not installed,
/// it cannot begin.
using FindKeeper = std::function<std::optional<SequenceCollider>(const std::string& name)>;

/// By the colliders that sequences name, each made once; `given` is asked about all, whoever they
/// name.
TrialOf trials_of_keepers(const FindKeeper& find, const std::optional<SequenceCollider>& given);

}  // namespace manifuzz
