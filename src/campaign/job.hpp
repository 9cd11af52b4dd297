#pragma once

#include <atomic>
#include <cstdint>
#include <limits>
#include <string>

#include "campaign/plan.hpp"
#include "process/pool.hpp"

namespace manifuzz {

// What the jobs of a run share with who began them, in shared memory.

enum class Step : int { generating, asking_subject, asking_oracle, judging };

inline constexpr CaseNumber kNoCase = std::numeric_limits<CaseNumber>::max();

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
struct CampaignRun {
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

/// What a job is at, where its parent can see it even if it dies.
struct CampaignJob {
  std::atomic<CaseNumber> next{0};  ///< the case at work
  std::atomic<CaseNumber> end{0};   ///< of the block at work
  std::atomic<Step> step{Step::generating};
  std::atomic<std::uint64_t> waits{0};  ///< moves while colliders in their own processes are asked
  Tally tally;

  void begin(Step next_step) { step.store(next_step, std::memory_order_relaxed); }
  /// Counts the case at work and goes on behind it. `frames`: of a sequence.
  void count(const Plan& plan, CampaignRun& run, const Standing& standing,
             const Judgement& judgement, std::size_t frames = 0) {
    tally.add(plan.regime_of(next), next, standing, judgement, frames);
    if (plan.ends_with && plan.ends_with(judgement)) run.find(next);
    next.fetch_add(1);
  }
};

}  // namespace manifuzz
