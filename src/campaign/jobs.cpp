#include "campaign/jobs.hpp"

#include <atomic>
#include <chrono>
#include <csignal>
#include <sys/wait.h>
#include <vector>

#include "cases/random.hpp"

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
  Tally tally;
};

struct Office {
  std::atomic<bool> stop{false};
  std::atomic<CaseNumber> undealt{0};
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

void run_case(const Plan& plan, CaseNumber number, Desk& desk) {
  desk.phase.store(Phase::generating, std::memory_order_relaxed);
  const PairCase pair = plan.pair(number);
  const auto truth = std::make_shared<const exact::Truth>(pair);
  const Standing where = standing(*truth);
  desk.phase.store(Phase::subject, std::memory_order_relaxed);
  const Answer of_subject = plan.subject.collide(pair);
  desk.phase.store(Phase::oracle, std::memory_order_relaxed);
  const Answer of_oracle = plan.oracle.collide(pair);
  desk.phase.store(Phase::judging, std::memory_order_relaxed);
  const Testimony subject{plan.subject.declaration, of_subject};
  const Testimony oracle{plan.oracle.declaration, of_oracle};
  Judgement judgement;
  if (is_sampled(plan, number) || !plainly_agree(*truth, subject, oracle)) {
    judgement = judge(truth, subject, oracle);
  }
  desk.tally.add(plan.regime_of(number), number, where, judgement);
}

void run_job(const Plan& plan, Office& office, Desk& desk) {
  const CaseNumber total = plan.cases_max();
  while (!office.stop.load(std::memory_order_relaxed)) {
    if (desk.next >= desk.end) {
      const CaseNumber begin = office.undealt.fetch_add(kBlock);
      if (begin >= total) return;
      desk.end = total - begin < kBlock ? total : begin + kBlock;
      desk.next = begin;
    }
    run_case(plan, desk.next, desk);
    desk.next.fetch_add(1);
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

  bool alive() const { return process_ > 0; }
  const Tally& tally() const { return desk_->tally; }

  /// Takes note of an end, and goes on behind a lost case.
  void look_after() {
    if (!alive()) return;
    if (desk_->next != seen_) {
      seen_ = desk_->next;
      seen_at_ = Clock::now();
    } else if (seconds_since(seen_at_) > kCaseSecondsMax) {
      kill_and_wait(process_);
      lose_case(Verdict::timed_out);
      return;
    }
    int status = 0;
    if (waitpid(process_, &status, WNOHANG) != process_) return;
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) {
      process_ = 0;
    } else {
      lose_case(Verdict::crashed);
    }
  }

  void kill() {
    if (alive()) kill_and_wait(process_);
    process_ = 0;
  }

 private:
  void start() {
    seen_at_ = Clock::now();
    process_ = spawn([this] { run_job(plan_, office_, *desk_); });
  }

  void lose_case(Verdict verdict) {
    const CaseNumber number = desk_->next;
    const Phase phase = desk_->phase;
    const Standing where =
        phase == Phase::generating ? Standing{} : standing(exact::Truth(plan_.pair(number)));
    desk_->tally.add(plan_.regime_of(number), number, where,
                     {.bucket = bucket_of_lost(verdict, fault_in(phase))});
    desk_->next.fetch_add(1);
    process_ = 0;
    if (!office_.stop) start();
  }

  const Plan& plan_;
  Office& office_;
  Shared<Desk> desk_;
  pid_t process_ = 0;
  CaseNumber seen_ = 0;
  Clock::time_point seen_at_;
};

std::unique_ptr<Tally> added(const std::vector<std::unique_ptr<Job>>& jobs) {
  auto total = std::make_unique<Tally>();
  for (const auto& job : jobs) total->add(job->tally());
  return total;
}

}  // namespace

JobsResult run_jobs(const Plan& plan, Interruption& interruption,
                    const std::function<void(const Progress&)>& on_progress) {
  const auto start = Clock::now();
  const Shared<Office> office;
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
  result.seconds = seconds_since(start);
  return result;
}

}  // namespace manifuzz
