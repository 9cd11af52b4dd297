#include "campaign/smoke.hpp"

#include <algorithm>
#include <chrono>
#include <thread>

#include "campaign/pairs/pair_trial.hpp"
#include "generating/regime.hpp"
#include "properties/properties.hpp"

namespace manifuzz {
namespace {

/// When each part must be done, as shares of the time; what is left is for pictures.
constexpr double kReplayShare = 0.25;
constexpr double kPropertyShare = 0.5;
constexpr double kCampaignShare = 0.75;
constexpr double kSavingShare = 0.95;
/// Where there is hardly any time, or a collider took nearly all of it to start.
constexpr double kCampaignSecondsMin = 0.5;
constexpr int kPropertyCases = 200;

std::vector<CheckedProperty> check_all(const SmokePlan& plan, const std::vector<PairCase>& pairs,
                                       const SmokeListener& listener) {
  const PropertyPlan each{plan.seed, kPropertyCases, pairs, {}};
  return check_properties(chosen_by_name(properties(), {}, "property", "property"), plan.subject,
                          each, plan.known, plan.at(kPropertyShare, 1), plan.save_to,
                          listener.on_checked);
}

Plan campaign_plan(const SmokePlan& smoke, const std::vector<PairCase>& pairs) {
  Plan plan;
  plan.subject = smoke.subject;
  plan.oracle = smoke.oracle;
  plan.regimes = regimes_for({plan.subject, plan.oracle}, {});
  narrow_to_colliders(plan);
  plan.context.corpus = pairs;
  plan.seed = smoke.seed;
  const std::chrono::duration<double> left = *smoke.at(kCampaignShare, 2) - Clock::now();
  plan.seconds = std::max(kCampaignSecondsMin, left.count() - smoke.start_seconds);
  plan.latest = std::max(*smoke.at(kSavingShare, 2), after(kCampaignSecondsMin));
  plan.judge_every = usual_judge_every(plan.subject, plan.oracle);
  plan.jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  return plan;
}

}  // namespace

Deadline SmokePlan::at(double share, int starts) const {
  const double work = std::max(0.0, seconds - 2 * start_seconds);
  const std::chrono::duration<double> until(
      std::min(seconds, starts * start_seconds + share * work));
  return start + std::chrono::duration_cast<Clock::duration>(until);
}

bool SmokeRun::is_well() const {
  return replayed.failed() == 0 && std::ranges::all_of(checked, &CheckedProperty::holds) &&
         !(campaign && has_failed(campaign->result));
}

SmokeRun run_smoke(const SmokePlan& plan, const SmokeListener& listener, Interruption& all) {
  SmokeRun run;
  run.pairs = pairs_of(plan.corpus, plan.seed);
  {
    Interruption in_time(
        {.first_signal = Interruption::State::stopped, .stopped_at = plan.at(kReplayShare, 1)});
    const auto trial = trial_of_pairs(plan.subject, plan.oracle);
    run.replayed = replay_cases(
        plan.known_cases.cases, [&](const CorpusCase&) { return trial; }, plan.known, in_time);
  }
  listener.on_replayed(run.replayed);
  if (!all.is_stopped()) run.checked = check_all(plan, run.pairs, listener);
  if (all.is_stopped()) return run;
  const Plan campaign = campaign_plan(plan, run.pairs);
  run.campaign =
      run_campaign(campaign, plan.known, {plan.save_to, plan.at(kSavingShare, 2)}, plan.origin,
                   [&](const Progress& progress) { listener.on_progress(campaign, progress); });
  listener.on_campaign(*run.campaign);
  return run;
}

}  // namespace manifuzz
