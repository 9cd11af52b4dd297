#include "campaign/smoke.hpp"

#include <algorithm>
#include <thread>

#include "base/names.hpp"
#include "corpus/known_cases.hpp"

namespace manifuzz {
namespace {

/// When each part must be done, as shares of the time; what is left is for pictures.
constexpr double kReplayShare = 0.25;
constexpr double kPropertyShare = 0.5;
constexpr double kCampaignShare = 0.75;
constexpr double kSavingShare = 0.95;
/// Where a collider took all of its time to start.
constexpr double kCampaignSecondsMin = 0.5;
constexpr int kPropertyCases = 200;

std::vector<CheckedProperty> check_all(const SmokePlan& plan, const std::vector<PairCase>& pairs,
                                       const SmokeListener& listener) {
  PropertyPlan each;
  each.seed = plan.seed;
  each.cases = kPropertyCases;
  each.corpus = pairs;
  return check_properties(chosen_by_name(properties(), {}, "property", "property"), plan.subject,
                          each, plan.at(kPropertyShare), plan.save_to, listener.on_checked);
}

Plan campaign_plan(const SmokePlan& smoke, const std::vector<PairCase>& pairs) {
  Plan plan;
  plan.subject = smoke.subject;
  plan.oracle = smoke.oracle;
  plan.regimes = chosen_by_name(regimes(), {}, "regime", "regime");
  narrow_to_colliders(plan);
  plan.context.corpus = pairs;
  plan.seed = smoke.seed;
  const std::chrono::duration<double> left = *smoke.at(kCampaignShare) - Clock::now();
  plan.seconds = std::max(kCampaignSecondsMin, left.count());
  plan.jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  return plan;
}

}  // namespace

Deadline SmokePlan::at(double share) const {
  return start + std::chrono::duration_cast<Clock::duration>(
                     std::chrono::duration<double>(share * seconds));
}

bool SmokeRun::is_well() const {
  return replayed.failed() == 0 && std::ranges::all_of(checked, &CheckedProperty::holds) &&
         !(campaign && has_failed(campaign->result));
}

SmokeRun run_smoke(const SmokePlan& plan, const SmokeListener& listener, Interruption& all) {
  const std::vector<PairCase> pairs = pairs_of(plan.corpus, plan.seed);
  SmokeRun run;
  {
    Interruption in_time(
        {.first_signal = Interruption::State::stopped, .stopped_at = plan.at(kReplayShare)});
    run.replayed = replay_cases(plan.corpus.cases, plan.subject, plan.oracle, in_time);
  }
  listener.on_replayed(run.replayed);
  if (!all.is_stopped()) run.checked = check_all(plan, pairs, listener);
  if (all.is_stopped()) return run;
  const Plan campaign = campaign_plan(plan, pairs);
  run.campaign = run_campaign(
      campaign, KnownBuckets(plan.corpus.cases), {plan.save_to, plan.at(kSavingShare)}, plan.origin,
      [&](const Progress& progress) { listener.on_progress(campaign, progress); });
  listener.on_campaign(*run.campaign);
  return run;
}

}  // namespace manifuzz
