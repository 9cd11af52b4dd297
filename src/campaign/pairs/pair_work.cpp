#include "campaign/pairs/pair_work.hpp"

#include <algorithm>
#include <vector>

#include "base/random.hpp"
#include "campaign/hints/hints.hpp"
#include "campaign/job.hpp"
#include "campaign/pairs/pair_trial.hpp"
#include "campaign/run.hpp"
#include "external/external_collider.hpp"
#include "judging/by_curve.hpp"
#include "judging/compare.hpp"

namespace manifuzz {
namespace {

constexpr std::uint64_t kPairBlock = 256;

/// One that is not worth all the cases: it answers a case otherwise alone than among others,
/// so often.
constexpr int kUnsteadyMax = 20;
constexpr const char* kUnsteady = "answers a case otherwise alone than among others";

/// A collider's answers to a block of cases, and how it has fared until now.
struct BlockAnswers {
  const Collider& collider;
  Fault role;
  std::vector<Answer> answers{};
  int lost_in_a_row = 0;
  int unsteady = 0;
};

/// Asks one in a process of its own for the whole block. How many cases have their answers, or get
/// them one by one: all but those behind an end of the run.
std::size_t ask_block(std::span<const PairCase> pairs, CampaignRun& run, CampaignJob& job,
                      BlockAnswers& of) {
  of.answers.resize(pairs.size());
  if (!of.collider.is_isolated()) return pairs.size();
  const std::size_t answered = of.collider.collide_many(pairs, of.answers, [&] {
    ++job.waits;
    return run.is_open();
  });
  for (std::size_t i = 0; i < answered; ++i) {
    if (std::holds_alternative<Unsupported>(of.answers[i])) continue;
    const auto* const lost = std::get_if<Lost>(&of.answers[i]);
    of.lost_in_a_row = lost != nullptr ? of.lost_in_a_row + 1 : 0;
    if (of.lost_in_a_row < kLossesInARowMax) continue;
    run.give_up(of.role, lost->why);
    return i + 1;
  }
  return answered;
}

/// The answer to case `i` of the block: the one that is there, or now.
ColliderAnswer ask_case(const PairCase& pair, std::size_t i, BlockAnswers& of) {
  if (!of.collider.is_isolated()) of.answers[i] = of.collider.collide(pair);
  return {of.collider.declaration, of.answers[i]};
}

/// Asks one that is blamed for its answer the case alone: what went wrong may lie in the asking, of
/// those who are asked for many cases at once. Whether its answer is another, or none, then.
bool is_unsteady(const Bucket& bucket, const PairCase& pair, std::size_t i, CampaignJob& job,
                 BlockAnswers& of) {
  const bool is_blamed = bucket.fault == of.role || bucket.fault == Fault::both;
  const bool has_answered = !is_of_lost(bucket) && !std::holds_alternative<Lost>(of.answers[i]);
  if (!of.collider.is_isolated() || !is_blamed || !has_answered) return false;
  Answer alone;
  of.collider.collide_many({&pair, 1}, {&alone, 1}, [&] {
    ++job.waits;
    return true;  // whatever time it is: a case that was asked is answered for
  });
  if (is_same(alone, of.answers[i])) return false;
  ++of.unsteady;
  of.answers[i] =
      std::holds_alternative<Lost>(alone) ? alone : Lost{Lost::How::malformed, kUnsteady};
  return true;
}

/// A case's way: two answers are compared, and judged where need be; the tally has it.
void run_case(const WorkOnPairs& work, const Plan& plan, const PairCase& pair, std::size_t i,
              CampaignRun& run, BlockAnswers& of_subject, BlockAnswers& of_oracle,
              CampaignJob& job) {
  const exact::Truth on_stack(pair);
  const std::shared_ptr<const exact::Truth> truth = exact::unowned(on_stack);
  job.begin(Step::asking_subject);
  const ColliderAnswer subject = ask_case(pair, i, of_subject);
  job.begin(Step::asking_oracle);
  const ColliderAnswer oracle = ask_case(pair, i, of_oracle);
  job.begin(Step::judging);
  Judgement judgement = judgement_on(plan, job.next, truth, subject, oracle);
  for (BlockAnswers* const of : {&of_subject, &of_oracle}) {
    if (is_unsteady(judgement.bucket, pair, i, job, *of)) judgement = judge(truth, subject, oracle);
  }
  work.learn(job.next, {truth, subject, judgement});
  job.count(plan, run, standing(*truth), judgement);
}

/// The cases of the job's block, to its end.
void run_block(const WorkOnPairs& work, const Plan& plan, CampaignRun& run, CampaignJob& job,
               BlockAnswers& of_subject, BlockAnswers& of_oracle) {
  job.begin(Step::generating);
  std::vector<PairCase> pairs;
  pairs.reserve(job.end - job.next);
  for (CaseNumber number = job.next; number < job.end; ++number) {
    pairs.push_back(work.pair(plan, number));
  }
  const std::size_t answered =
      std::min({ask_block(pairs, run, job, of_subject), ask_block(pairs, run, job, of_oracle)});
  for (std::size_t i = 0; i < answered && job.next < run.sought; ++i) {
    run_case(work, plan, pairs[i], i, run, of_subject, of_oracle, job);
    for (const BlockAnswers* const of : {&of_subject, &of_oracle}) {
      if (of->unsteady < kUnsteadyMax) continue;
      return run.give_up(of->role, kUnsteady);
    }
  }
}

/// One agreeing case in `judge_every`, by what the case is and not by its place in the campaign:
/// alone it is sampled too.
bool is_sampled(const Plan& plan, CaseNumber number) {
  const std::uint64_t stream = plan.regimes[plan.regime_of(number)]->stream;
  return mix(plan.index_of(number) ^ mix(plan.seed ^ stream)) % plan.judge_every == 0;
}

}  // namespace

Judgement judgement_on(const Plan& plan, CaseNumber number,
                       const std::shared_ptr<const exact::Truth>& truth,
                       const ColliderAnswer& subject, const ColliderAnswer& oracle) {
  if (plan.judge_every == 1) return judge(truth, subject, oracle);
  const bool agree = plainly_agree(*truth, subject, oracle);
  // That neither reports a contact is held exactly in comparing them.
  const bool is_agreed_contact = agree && touches(subject.answer);
  if (agree && !is_sampled(plan, number)) {
    return {.is_judged = !is_agreed_contact, .is_agreed_contact = is_agreed_contact};
  }
  Judgement judgement = judge(truth, subject, oracle);
  judgement.is_agreed_contact = is_agreed_contact;
  return judgement;
}

std::uint64_t WorkOnPairs::block_length() const {
  return kPairBlock;
}

PairCase WorkOnPairs::pair(const Plan& plan, CaseNumber number) const {
  return plan.pair(number);
}

std::shared_ptr<const Trial> WorkOnPairs::trial(const Plan& plan) const {
  return trial_of_pairs(plan.subject, plan.oracle);
}

std::function<void()> WorkOnPairs::block_runner(const Plan& plan, CampaignRun& run,
                                                CampaignJob& job) const {
  return [this, &plan, &run, &job, of_subject = BlockAnswers{plan.subject, Fault::subject},
          of_oracle = BlockAnswers{plan.oracle, Fault::oracle}]() mutable {
    run_block(*this, plan, run, job, of_subject, of_oracle);
  };
}

std::vector<Hint> WorkOnPairs::hints(const Tally& tally, const Plan& plan,
                                     Interruption& interruption) const {
  return hints_of(tally, plan, interruption);
}

std::shared_ptr<const KindOfWork> work_on_pairs() {
  static const auto only = std::make_shared<const WorkOnPairs>();
  return only;
}

}  // namespace manifuzz
