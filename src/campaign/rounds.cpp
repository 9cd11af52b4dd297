#include "campaign/rounds.hpp"

#include <algorithm>

namespace manifuzz {
namespace {

/// The first round is over in a moment. Each is twice as long as the one before, so that a round's
/// start weighs little, up to a few seconds.
constexpr CaseNumber kFirstRound = 1024;
constexpr CaseNumber kLongestRound = 1 << 18;

/// Adds a round that came behind the others.
void append(JobsResult round, JobsResult& all) {
  round.tally->add(*all.tally);
  round.seconds += all.seconds;
  all = std::move(round);
}

/// The plan with the time that is left of it.
Plan rest_of(const Plan& plan, double seconds_gone) {
  Plan rest = plan;
  if (plan.seconds) rest.seconds = *plan.seconds - seconds_gone;
  return rest;
}

}  // namespace

JobsResult run_plan(const Plan& plan, const KnownBuckets& known, Interruption& interruption,
                    const std::function<void(const Progress&)>& on_progress) {
  const CaseNumber end = plan.cases_max();
  if (!plan.until_new) return run_jobs(plan, {0, end}, interruption, on_progress);
  JobsResult all{.tally = std::make_unique<Tally>()};
  CaseNumber length = kFirstRound;
  for (CaseNumber begin = 0; begin < end; begin += length) {
    if (begin > 0) length = std::min(2 * length, kLongestRound);
    length = std::min(length, end - begin);
    append(run_jobs(rest_of(plan, all.seconds), {begin, begin + length}, interruption,
                    [&](const Progress& round) {
                      const auto so_far = std::make_unique<Tally>(round.tally);
                      so_far->add(*all.tally);
                      on_progress({*so_far, all.seconds + round.seconds});
                    }),
           all);
    const bool is_time_up = plan.seconds && all.seconds >= *plan.seconds;
    const bool is_stopped = all.interrupted || all.unresponsive != Fault::none || is_time_up;
    if (is_stopped || has_new(findings(*all.tally, plan, known))) break;
  }
  return all;
}

}  // namespace manifuzz
