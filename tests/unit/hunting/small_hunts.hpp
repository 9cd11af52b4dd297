#pragma once

#include <nlohmann/json.hpp>

#include "hunting/hunt.hpp"

namespace manifuzz::test {

/// A hunt of cases of all regimes, under seed 4.
inline HuntPlan plan_of(const Collider& subject, const Collider& oracle, std::uint64_t cases,
                        int jobs) {
  HuntPlan hunt;
  Plan& plan = hunt.plan;
  plan.subject = subject;
  plan.oracle = oracle;
  for (const Regime& regime : regimes()) plan.regimes.push_back(&regime);
  plan.seed = 4;
  plan.cases = cases;
  plan.jobs = jobs;
  return hunt;
}

inline Hunt run(
    const HuntPlan& plan, const SaveTo& save_to = {},
    const OnHuntProgress& on_progress = [](const HuntProgress&) {}) {
  const Origin nowhere{
      "manifuzz hunt",
      {{"machine", ""}, {"compiler", ""}, {"versions", nlohmann::ordered_json::object()}}};
  return run_hunt(plan, {}, save_to, nowhere, on_progress);
}

}  // namespace manifuzz::test
