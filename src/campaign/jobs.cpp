#include <algorithm>
#include <atomic>
#include <chrono>
#include <limits>
#include <vector>

#include "campaign/in_child.hpp"
#include "campaign/run.hpp"
#include "campaign/sequences/sequence_case.hpp"
#include "external/external_collider.hpp"
#include "process/pool.hpp"

namespace manifuzz {
namespace {

/// Cases are handed out in blocks, small enough that no job is left behind at the end.
constexpr std::uint64_t kBlock = 256;
/// A sequence takes as long as tens of cases.
constexpr std::uint64_t kSequenceBlock = 8;

enum class Step : int { generating, asking_subject, asking_oracle, judging };

/// What a job is at, where its parent can see it even if it dies.
struct JobState {
  std::atomic<CaseNumber> next{0};  ///< the case at work
  std::atomic<CaseNumber> end{0};   ///< of the block at work
  std::atomic<Step> step{Step::generating};
  std::atomic<std::uint64_t> waits{0};  ///< moves while colliders in their own processes are asked
  Tally tally;

  void begin(Step next_step) { step.store(next_step, std::memory_order_relaxed); }
};

constexpr CaseNumber kNoCase = std::numeric_limits<CaseNumber>::max();

/// A run's time, which begins with its first answer: until then programs start.
struct RunClock {
  std::atomic<Clock::rep> began_at{0};  ///< 0: it has not begun

  void begin() {
    Clock::rep not_yet = 0;
    began_at.compare_exchange_strong(not_yet, Clock::now().time_since_epoch().count());
  }
  double seconds() const {
    const Clock::rep began = began_at;
    return began == 0 ? 0 : seconds_since(Clock::time_point(Clock::duration(began)));
  }
};

/// What all jobs share.
struct RunState {
  SharedQueue cases;
  RunClock clock;
  double seconds_max = std::numeric_limits<double>::infinity();
  std::atomic<CaseNumber> sought{kNoCase};  ///< the least that ends the run
  std::atomic<Fault> given_up{Fault::none};
  SharedText<256> why_given_up;  ///< of the first that was given up

  bool is_open() {
    if (clock.seconds() > seconds_max) cases.is_closed = true;
    return cases.is_open();
  }
  void find(CaseNumber number) {
    CaseNumber least = sought;
    while (number < least && !sought.compare_exchange_weak(least, number)) {
    }
  }
  void give_up(Fault role, const std::string& why) {
    Fault none = Fault::none;
    if (given_up.compare_exchange_strong(none, role)) why_given_up.set(why);
    cases.is_closed = true;
  }
};

/// The share of the time that a signal leaves in which jobs end; the rest is for what they found.
constexpr double kShareOfJobs = 0.4;

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
std::size_t ask_block(std::span<const PairCase> pairs, RunState& run, JobState& job,
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
bool is_unsteady(const Bucket& bucket, const PairCase& pair, std::size_t i, JobState& job,
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
void run_case(const Plan& plan, const PairCase& pair, std::size_t i, RunState& run,
              BlockAnswers& of_subject, BlockAnswers& of_oracle, JobState& job) {
  const CaseNumber number = job.next;
  const exact::Truth truth(pair);
  job.begin(Step::asking_subject);
  const ColliderAnswer subject = ask_case(pair, i, of_subject);
  job.begin(Step::asking_oracle);
  const ColliderAnswer oracle = ask_case(pair, i, of_oracle);
  job.begin(Step::judging);
  Judgement judgement = judgement_on(plan, number, truth, subject, oracle);
  for (BlockAnswers* const of : {&of_subject, &of_oracle}) {
    if (is_unsteady(judgement.bucket, pair, i, job, *of)) judgement = judge(pair, subject, oracle);
  }
  job.tally.add(plan.regime_of(number), number, standing(truth), judgement);
  if (plan.ends_with && plan.ends_with(judgement)) run.find(number);
}

/// The cases of the job's block, to its end.
void run_block(const Plan& plan, RunState& run, JobState& job, BlockAnswers& of_subject,
               BlockAnswers& of_oracle) {
  job.begin(Step::generating);
  std::vector<PairCase> pairs;
  pairs.reserve(job.end - job.next);
  for (CaseNumber number = job.next; number < job.end; ++number) pairs.push_back(plan.pair(number));
  const std::size_t answered =
      std::min({ask_block(pairs, run, job, of_subject), ask_block(pairs, run, job, of_oracle)});
  for (std::size_t i = 0; i < answered && job.next < run.sought; ++i) {
    run_case(plan, pairs[i], i, run, of_subject, of_oracle, job);
    job.next.fetch_add(1);
    for (const BlockAnswers* const of : {&of_subject, &of_oracle}) {
      if (of->unsteady < kUnsteadyMax) continue;
      return run.give_up(of->role, kUnsteady);
    }
  }
}

/// The sequences of the job's block, to its end or that of the run.
void run_sequences(const Plan& plan, RunState& run, JobState& job, BlockAnswers& of_subject) {
  const SequenceCollider subject = watched(plan.sequences->subject, [&job] { ++job.waits; });
  while (job.next < job.end && job.next < run.sought && run.is_open()) {
    const CaseNumber number = job.next;
    job.begin(Step::generating);
    const Sequence sequence = plan.sequence(number);
    job.begin(Step::asking_subject);
    const std::vector<KeptAnswer> answers = ask_sequence(subject, sequence);
    job.begin(Step::judging);
    const Judgement judgement = counted(judge_sequence(sequence, subject, answers));
    job.tally.add(plan.regime_of(number), number, standing(sequence), judgement,
                  sequence.frames.size());
    if (plan.ends_with && plan.ends_with(judgement)) run.find(number);
    job.next.fetch_add(1);
    const auto* const lost = std::get_if<Lost>(&answers.back());
    of_subject.lost_in_a_row = lost != nullptr ? of_subject.lost_in_a_row + 1 : 0;
    if (of_subject.lost_in_a_row >= kLossesInARowMax) run.give_up(Fault::subject, lost->why);
  }
}

void run_job(const Plan& plan, RunState& run, JobState& job) {
  BlockAnswers of_subject{plan.subject, Fault::subject};
  BlockAnswers of_oracle{plan.oracle, Fault::oracle};
  std::uint64_t length = 1;  // the first answer is there the sooner
  while (run.is_open()) {
    if (job.next >= job.end) {
      const SharedQueue::Block block = run.cases.take(length);
      length = plan.sequences ? kSequenceBlock : kBlock;
      if (block.begin >= block.end || block.begin > run.sought) return;
      job.end = block.end;
      job.next = block.begin;
    }
    if (plan.sequences) {
      run_sequences(plan, run, job, of_subject);
    } else {
      run_block(plan, run, job, of_subject, of_oracle);
    }
    run.clock.begin();
    if (job.next >= run.sought) return;
  }
}

Standing standing_of(const Plan& plan, CaseNumber number) {
  return plan.sequences ? standing(plan.sequence(number))
                        : standing(exact::Truth(plan.pair(number)));
}

/// The case that a job died or hung at is a finding of its own.
void lose_case(const Plan& plan, RunState& run, JobState& job, Ending ending,
               Interruption& interruption) {
  const CaseNumber number = job.next;
  const Step step = job.step;
  const Fault fault = step == Step::asking_subject  ? Fault::subject
                      : step == Step::asking_oracle ? Fault::oracle
                                                    : Fault::none;
  const Standing where = step == Step::generating ? Standing{} : standing_of(plan, number);
  Judgement judgement{.bucket = bucket_of_lost(ending, fault)};
  if (!plan.sequences && step != Step::generating) {
    unless_interrupted([&] {
      judgement =
          judge_lost(plan.pair(number), plan.subject, plan.oracle, {ending, fault}, interruption);
    });
  }
  const bool has_frames = plan.sequences && step != Step::generating;
  job.tally.add(plan.regime_of(number), number, where, judgement,
                has_frames ? plan.sequence(number).frames.size() : 0);
  if (plan.ends_with && plan.ends_with(judgement)) run.find(number);
  job.next.fetch_add(1);
}

std::unique_ptr<Tally> added(const Shared<JobState>& jobs) {
  auto total = std::make_unique<Tally>();
  for (const JobState& job : jobs.all()) total->add(job.tally);
  return total;
}

}  // namespace

JobsResult run_jobs(const Plan& plan, SharedQueue::Block cases, Interruption& interruption,
                    const OnProgress& on_progress) {
  const Shared<RunState> run;
  run->cases.next = cases.begin;
  run->cases.end = cases.end;
  run->seconds_max = plan.seconds.value_or(run->seconds_max);
  const Shared<JobState> jobs(plan.jobs);
  Interruption until_time_is_up(
      {.begins = interruption.state(), .hurried_at = plan.latest, .share = kShareOfJobs});
  const Pool pool{.jobs = plan.jobs,
                  .body = [&](int job) { run_job(plan, *run, jobs[job]); },
                  .progress = [&](int job) { return jobs[job].next + jobs[job].waits; },
                  .seconds_max = case_seconds_max(plan.subject, plan.oracle),
                  .on_lost =
                      [&](int job, Ending ending) {
                        lose_case(plan, *run, jobs[job], ending, until_time_is_up);
                        return run->is_open();
                      },
                  .hurry = &run->cases.is_closed,
                  .on_tick =
                      [&](double) {
                        on_progress({*added(jobs), run->clock.seconds()});
                      }};
  run_pool(pool, until_time_is_up);
  return {.tally = added(jobs),
          .seconds = run->clock.seconds(),
          .interrupted = interruption.state() != Interruption::State::running,
          .sought = run->sought == kNoCase ? std::nullopt : std::optional(run->sought.load()),
          .given_up = run->given_up,
          .why_given_up = run->why_given_up.str()};
}

}  // namespace manifuzz
