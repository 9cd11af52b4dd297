#include "hunting/property_checks.hpp"

#include <algorithm>

#include "campaign/job.hpp"
#include "campaign/property_failure.hpp"

namespace manifuzz {
namespace {

using OutcomeKind = PropertyOutcome::Kind;

/// What a collider that died or hung is off by, as a property has it that is told of that.
constexpr double kMagnitudeOfLost = 1;

Aim aim_at_properties(std::size_t count) {
  return {.gauges = count,
          .seeks = [](std::size_t) { return true; },
          .value = [](const Observation& observed) { return std::ranges::max(observed.gauges); }};
}

}  // namespace

double measure_of(const PropertyOutcome& outcome) {
  if (outcome.kind == OutcomeKind::holds) return outcome.of_bound;
  return outcome.kind == OutcomeKind::fails ? 1 + outcome.magnitude : 0;
}

PropertyChecks::PropertyChecks(const std::vector<const Property*>& properties, const Plan& plan)
    : HuntedPairs({plan.regimes, {}, aim_at_properties(properties.size())}, plan),
      checked_(kLongestGeneration) {
  for (const Property* const property : properties) hunted_.push_back({.property = property});
}

void PropertyChecks::run_case(const Plan& plan, const Collider& subject, CampaignRun& run,
                              CampaignJob& job) const {
  job.begin(Step::generating);
  const CaseNumber number = job.next;
  const PairCase pair = this->pair(plan, number);
  const exact::Truth truth(pair);
  Observation observed = conditions_observed(truth, subject.declaration);
  CheckedCase& checked = checked_[number - cases().begin];
  checked = {.is_begun = true};
  job.begin(Step::asking_subject);
  for (std::size_t k = 0; k < hunted_.size(); ++k) {
    const PropertyOutcome outcome = check(*hunted_[k].property, subject, pair);
    observed.gauges[k] = measure_of(outcome);
    checked.checks[k] = {outcome.kind, observed.gauges[k]};
    ++checked.done;
    ++job.waits;
  }
  job.begin(Step::judging);
  if (!run.is_open()) {
    checked = {};  // some of it may have been declined
    return;
  }
  note(number, observed);
  job.count(plan, run, standing(truth), {});
}

std::function<void()> PropertyChecks::block_runner(const Plan& plan, CampaignRun& run,
                                                   CampaignJob& job) const {
  const auto is_over = [&run, &job] {
    ++job.waits;
    return !run.is_open();
  };
  return [this, &plan, &run, &job, subject = until(is_over, plan.subject)] {
    while (job.next < job.end && run.is_open()) run_case(plan, subject, run, job);
  };
}

void PropertyChecks::add_check(const Plan& plan, CaseNumber number, std::size_t k,
                               const OneCheck& check) {
  HuntedProperty& hunted = hunted_[k];
  const bool is_first = check.kind == OutcomeKind::fails && !hunted.first;
  ++hunted.cases;
  hunted.applied += static_cast<std::uint64_t>(check.kind != OutcomeKind::not_applicable);
  if (is_first) hunted.first = number;
  if (check.kind == OutcomeKind::fails && (is_first || check.measure > hunted.worst)) {
    hunted.failing = pair(plan, number);
    hunted.failing_number = number;
  }
  hunted.worst = std::max(hunted.worst, check.measure);
}

void PropertyChecks::end_checks(const Plan& plan, const JobsResult& part) {
  const auto is_halfway = [&](const CheckedCase& checked) {
    return checked.is_begun && checked.done < hunted_.size();
  };
  // A job that was stopped leaves a case halfway, too.
  const auto lost = part.tally->count(Verdict::crashed) + part.tally->count(Verdict::timed_out);
  const bool are_lost =
      static_cast<std::uint64_t>(std::ranges::count_if(checked_.all(), is_halfway)) <= lost;
  for (CaseNumber number = cases().begin; number < cases().end; ++number) {
    const CheckedCase& checked = checked_[number - cases().begin];
    for (std::size_t k = 0; k < checked.done; ++k) add_check(plan, number, k, checked.checks[k]);
    if (is_halfway(checked) && are_lost) {
      add_check(plan, number, checked.done, {OutcomeKind::fails, 1 + kMagnitudeOfLost});
    }
  }
  std::ranges::fill(checked_.all(), CheckedCase{});
}

}  // namespace manifuzz
