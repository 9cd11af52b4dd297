#include "campaign/jobs.hpp"

#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <optional>
#include <vector>

#include "base/random.hpp"
#include "judging/completed.hpp"
#include "oracle/external/external_collider.hpp"
#include "process/watched_process.hpp"

namespace manifuzz {
namespace {

using Clock = std::chrono::steady_clock;

/// Cases are handed out in blocks, small enough that no job is left behind at the end.
constexpr std::uint64_t kBlock = 256;
constexpr double kPollSeconds = 0.1;

enum class Phase : int { generating, subject, oracle, judging };

/// A job's desk, where its parent can see what it is at.
struct Desk {
  std::atomic<CaseNumber> next{0};  ///< the case at work
  std::atomic<CaseNumber> end{0};   ///< of the block at work
  std::atomic<Phase> phase{Phase::generating};
  std::atomic<int> pulse{0};  ///< moves while it waits for colliders in processes of their own
  Tally tally;
};

struct Office {
  std::atomic<bool> stop{false};
  std::atomic<Fault> unresponsive{Fault::none};  ///< who never answers, so that going on is no use
  std::array<char, 256> why{};                   ///< of the one that gave up first
  std::atomic<CaseNumber> undealt{0};
  CaseNumber end = 0;

  void give_up(Fault party, const std::string& reason) {
    Fault nobody = Fault::none;
    if (unresponsive.compare_exchange_strong(nobody, party))
      reason.copy(why.data(), why.size() - 1);
    stop = true;
  }
};

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// One agreeing case in `judge_every`, by what the case is and not by its place in the campaign:
/// alone it is sampled too.
bool is_sampled(const Plan& plan, CaseNumber number) {
  const std::uint64_t stream = hash_of(plan.regimes[plan.regime_of(number)]->name);
  return mix(plan.index_of(number) ^ mix(plan.seed ^ stream)) % plan.judge_every == 0;
}

/// One that is not worth all the cases: it answers a case otherwise alone than among others,
/// so often.
constexpr int kUnsteadyMax = 20;

/// What a collider in a process of its own answered to a block of cases, and how often it has just
/// failed to.
struct Correspondence {
  const Collider& collider;
  Fault party;
  std::vector<Answer> answers{};
  int losses_in_a_row = 0;
  int unsteady = 0;

  /// How many it answered before it was time to stop.
  std::size_t ask(std::span<const PairCase> pairs, Office& office, Desk& desk) {
    answers.assign(pairs.size(), Answer());
    if (!collider.is_isolated()) return pairs.size();
    const std::size_t answered = collider.collide_many(pairs, answers, [&] {
      ++desk.pulse;
      return !office.stop.load(std::memory_order_relaxed);
    });
    for (std::size_t i = 0; i < answered; ++i) {
      if (std::holds_alternative<Unsupported>(answers[i])) continue;
      const auto* const lost = std::get_if<Lost>(&answers[i]);
      losses_in_a_row = lost != nullptr ? losses_in_a_row + 1 : 0;
      if (losses_in_a_row < kLossesInARowMax) continue;
      office.give_up(party, lost->why);
      return i + 1;
    }
    return answered;
  }
};

/// Its answer to case `i` of a block: the one it gave already, or now.
const Answer& answer_to(const PairCase& pair, std::size_t i, Correspondence& with) {
  if (!with.collider.is_isolated()) with.answers[i] = with.collider.collide(pair);
  return with.answers[i];
}

/// What went wrong may lie in the asking: one that answers a case otherwise alone than among others
/// has no answer to it.
std::optional<Judgement> without_answer(const PairCase& pair, const Answer& given,
                                        const Bucket& bucket, Correspondence& with) {
  if (!with.collider.is_isolated() || bucket.verdict == Verdict::malformed ||
      (bucket.fault != with.party && bucket.fault != Fault::both) ||
      std::holds_alternative<Lost>(given) || is_same(with.collider.collide(pair), given)) {
    return std::nullopt;
  }
  ++with.unsteady;
  return Judgement{.bucket = bucket_of_lost(Verdict::malformed, with.party)};
}

void run_case(const Plan& plan, CaseNumber number, const PairCase& pair, std::size_t in_block,
              Correspondence& with_subject, Correspondence& with_oracle, Desk& desk) {
  const auto truth = std::make_shared<const exact::Truth>(pair);
  const Standing where = standing(*truth);
  desk.phase.store(Phase::subject, std::memory_order_relaxed);
  const Answer& of_subject = answer_to(pair, in_block, with_subject);
  desk.phase.store(Phase::oracle, std::memory_order_relaxed);
  const Answer& of_oracle = answer_to(pair, in_block, with_oracle);
  desk.phase.store(Phase::judging, std::memory_order_relaxed);
  const ColliderAnswer subject{plan.subject.declaration, of_subject};
  const ColliderAnswer oracle{plan.oracle.declaration, of_oracle};
  Judgement judgement;
  if (is_sampled(plan, number) || !plainly_agree(*truth, subject, oracle)) {
    judgement = judge(truth, subject, oracle);
    for (const auto& [with, given] :
         {std::pair(&with_subject, &of_subject), std::pair(&with_oracle, &of_oracle)}) {
      if (const auto lost = without_answer(pair, *given, judgement.bucket, *with))
        judgement = *lost;
    }
  }
  desk.tally.add(plan.regime_of(number), number, where, judgement);
}

/// The cases at the desk, to the end of its block.
void run_block(const Plan& plan, Office& office, Desk& desk, Correspondence& with_subject,
               Correspondence& with_oracle) {
  desk.phase.store(Phase::generating, std::memory_order_relaxed);
  std::vector<PairCase> pairs;
  for (CaseNumber number = desk.next; number < desk.end; ++number) {
    pairs.push_back(plan.pair(number));
  }
  const std::size_t answered =
      std::min(with_subject.ask(pairs, office, desk), with_oracle.ask(pairs, office, desk));
  for (std::size_t i = 0; i < answered; ++i) {
    run_case(plan, desk.next, pairs[i], i, with_subject, with_oracle, desk);
    desk.next.fetch_add(1);
    for (const Correspondence* const with : {&with_subject, &with_oracle}) {
      if (with->unsteady < kUnsteadyMax) continue;
      return office.give_up(with->party, "answers a case otherwise alone than among others");
    }
  }
}

void run_job(const Plan& plan, Office& office, Desk& desk) {
  Correspondence with_subject{plan.subject, Fault::subject};
  Correspondence with_oracle{plan.oracle, Fault::oracle};
  while (!office.stop.load(std::memory_order_relaxed)) {
    if (desk.next >= desk.end) {
      const CaseNumber begin = office.undealt.fetch_add(kBlock);
      if (begin >= office.end) return;
      desk.end = office.end - begin < kBlock ? office.end : begin + kBlock;
      desk.next = begin;
    }
    run_block(plan, office, desk, with_subject, with_oracle);
  }
}

Fault fault_in(Phase phase) {
  if (phase == Phase::subject) return Fault::subject;
  return phase == Phase::oracle ? Fault::oracle : Fault::none;
}

/// The parent's side of one job.
class Job {
 public:
  Job(const Plan& plan, Office& office) : plan_(plan), office_(office) { start(); }

  bool alive() const { return process_.alive(); }
  const Tally& tally() const { return desk_->tally; }

  /// Takes note of an end, and goes on behind a lost case.
  void look_after() {
    if (!alive()) return;
    const std::uint64_t pulse = desk_->next + static_cast<std::uint64_t>(desk_->pulse);
    switch (process_.look(pulse, case_seconds_max(plan_.subject, plan_.oracle))) {
      case WatchedProcess::State::crashed:
        return lose_case(Verdict::crashed);
      case WatchedProcess::State::hung:
        return lose_case(Verdict::timed_out);
      default:
        return;
    }
  }

  void kill() { process_.kill(); }

 private:
  void start() {
    process_.start([this] { run_job(plan_, office_, *desk_); });
  }

  void lose_case(Verdict verdict) {
    const CaseNumber number = desk_->next;
    const Phase phase = desk_->phase;
    const Standing where =
        phase == Phase::generating ? Standing{} : standing(exact::Truth(plan_.pair(number)));
    desk_->tally.add(plan_.regime_of(number), number, where,
                     {.bucket = bucket_of_lost(verdict, fault_in(phase))});
    desk_->next.fetch_add(1);
    if (!office_.stop) start();
  }

  const Plan& plan_;
  Office& office_;
  Shared<Desk> desk_;
  WatchedProcess process_;
};

std::unique_ptr<Tally> added(const std::vector<std::unique_ptr<Job>>& jobs) {
  auto total = std::make_unique<Tally>();
  for (const auto& job : jobs) total->add(job->tally());
  return total;
}

}  // namespace

JobsResult run_jobs(const Plan& plan, Stretch stretch, Interruption& interruption,
                    const std::function<void(const Progress&)>& on_progress) {
  const auto start = Clock::now();
  const Shared<Office> office;
  office->undealt = stretch.begin;
  office->end = stretch.end;
  std::vector<std::unique_ptr<Job>> jobs;
  for (int i = 0; i < plan.jobs; ++i) jobs.push_back(std::make_unique<Job>(plan, *office));

  JobsResult result;
  double progress_at = 0;
  const auto any_alive = [&jobs] {
    return std::any_of(jobs.begin(), jobs.end(), [](const auto& job) { return job->alive(); });
  };
  while (any_alive()) {
    const double now = seconds_since(start);
    const double left = plan.seconds ? *plan.seconds - now : kPollSeconds;
    interruption.wait(std::clamp(left, 0.001, kPollSeconds));
    result.interrupted = interruption.requested();
    if (result.interrupted || (plan.seconds && seconds_since(start) >= *plan.seconds)) {
      office->stop = true;
    }
    for (const auto& job : jobs) {
      interruption.requests() > 1 ? job->kill() : job->look_after();
    }
    if (now - progress_at >= 2 * kPollSeconds) {
      progress_at = now;
      on_progress({*added(jobs), now});
    }
  }
  result.tally = added(jobs);
  result.unresponsive = office->unresponsive;
  result.why_unresponsive = office->why.data();
  result.seconds = seconds_since(start);
  return result;
}

}  // namespace manifuzz
