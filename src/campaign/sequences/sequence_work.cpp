#include "campaign/sequences/sequence_work.hpp"

#include <fmt/format.h>

#include "base/text.hpp"
#include "campaign/job.hpp"
#include "campaign/sequences/keeper_trial.hpp"
#include "campaign/sequences/sequence_case.hpp"
#include "exchange/json.hpp"
#include "external/external_collider.hpp"
#include "sequence/motions.hpp"

namespace manifuzz {
namespace {

/// A sequence takes as long as tens of cases.
constexpr std::uint64_t kSequenceBlock = 8;

class WorkOnSequences : public KindOfWork {
 public:
  WorkOnSequences(const SequenceCollider& subject, std::vector<const Motion*> motions)
      : trial_(std::make_shared<const KeeperTrial>(subject)), motions_(std::move(motions)) {}

  CaseKind kind() const override { return CaseKind::sequence; }
  std::string_view noun() const override { return "sequences"; }
  std::uint64_t block_length() const override { return kSequenceBlock; }
  std::shared_ptr<const Trial> trial(const Plan&) const override { return trial_; }
  AnyCase draw(const Plan& plan, CaseNumber number) const override { return drawn(plan, number); }

  std::function<void()> block_runner(const Plan& plan, CampaignRun& run,
                                     CampaignJob& job) const override {
    return [this, &plan, &run, &job, lost_in_a_row = 0,
            subject = watched(keeper(), [&job] { ++job.waits; })]() mutable {
      while (job.next < job.end && job.next < run.sought && run.is_open()) {
        const std::optional<Lost> lost = run_one(plan, run, job, subject);
        lost_in_a_row = lost ? lost_in_a_row + 1 : 0;
        if (lost_in_a_row >= kLossesInARowMax) run.give_up(Fault::subject, lost->why);
      }
    };
  }

 private:
  const SequenceCollider& keeper() const { return trial_->keeper(); }

  Sequence drawn(const Plan& plan, CaseNumber number) const {
    return draw_sequence(plan.seed, *motions_[plan.regime_of(number)], plan.index_of(number),
                         [this](const Sequence& one) { return takes(keeper(), one); });
  }

  /// What was lost of it, if anything.
  std::optional<Lost> run_one(const Plan& plan, CampaignRun& run, CampaignJob& job,
                              const SequenceCollider& subject) const {
    job.begin(Step::generating);
    const Sequence sequence = drawn(plan, job.next);
    job.begin(Step::asking_subject);
    const std::vector<KeptAnswer> answers = ask_sequence(subject, sequence);
    job.begin(Step::judging);
    Judgement judgement = counted(judge_sequence(sequence, subject, answers));
    judgement.explanation = nullptr;  // the ledger over frames is not counted
    job.count(plan, run, standing(sequence), judgement, sequence.frames.size());
    const auto* const lost = std::get_if<Lost>(&answers.back());
    return lost != nullptr ? std::optional(*lost) : std::nullopt;
  }

  std::shared_ptr<const KeeperTrial> trial_;
  std::vector<const Motion*> motions_;  ///< in the places of the plan's regimes
};

/// A motion's name, where regimes are counted.
const Regime* named_after(const Motion& motion) {
  static const std::vector<Regime> all = [] {
    std::vector<Regime> regimes;
    for (const Motion& one : motions()) regimes.push_back({one.name, one.description, nullptr});
    return regimes;
  }();
  return find_by_name(all, motion.name);
}

}  // namespace

void plan_sequences(Plan& plan, const SequenceCollider& subject,
                    std::span<const std::string> names) {
  plan.subject.declaration = subject.declaration;
  plan.subject.declaration.claims = Claims::manifold;  // a point at a time, but all are judged
  plan.oracle = {};
  plan.oracle.declaration.name = kJudgeName;
  std::vector<const Motion*> chosen = chosen_by_name(motions(), names, "motion", "--regime");
  if (names.empty()) {
    std::erase_if(chosen, [&](const Motion* motion) {
      return !has_taken(*motion, [&](const Sequence& drawn) { return takes(subject, drawn); });
    });
  }
  if (chosen.empty()) {
    throw UserError(
        fmt::format("{} takes no shapes that any motion has", subject.declaration.name));
  }
  for (const Motion* const motion : chosen) plan.regimes.push_back(named_after(*motion));
  plan.work = std::make_shared<const WorkOnSequences>(subject, std::move(chosen));
}

}  // namespace manifuzz
