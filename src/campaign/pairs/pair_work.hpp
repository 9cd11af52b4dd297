#pragma once

#include <memory>

#include "campaign/plan.hpp"
#include "campaign/work.hpp"
#include "judging/compare.hpp"

namespace manifuzz {

/// A pair case whose answers were judged.
struct JudgedPair {
  const std::shared_ptr<const exact::Truth>& truth;
  ColliderAnswer subject;
  const Judgement& judgement;
};

/// Pair cases of the plan's regimes; what derives from it may take them from elsewhere, and learn
/// from what became of them.
class WorkOnPairs : public KindOfWork {
 public:
  CaseKind kind() const override { return CaseKind::pair; }
  std::string_view noun() const override { return "cases"; }
  std::uint64_t block_length() const override;
  AnyCase draw(const Plan& plan, CaseNumber number) const override { return pair(plan, number); }
  std::shared_ptr<const Trial> trial(const Plan& plan) const override;
  std::function<void()> block_runner(const Plan& plan, CampaignRun& run,
                                     CampaignJob& job) const override;
  std::vector<Hint> hints(const Tally& tally, const Plan& plan,
                          Interruption& interruption) const override;

  virtual PairCase pair(const Plan& plan, CaseNumber number) const;
  /// Runs in the job's process once the case of that number is judged.
  virtual void learn(CaseNumber number, const JudgedPair& judged) const {
    (void)number, (void)judged;
  }
};

}  // namespace manifuzz
