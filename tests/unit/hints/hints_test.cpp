#include "campaign/hints/hints.hpp"

#include <catch2/catch.hpp>

#include "campaign/run.hpp"
#include "generating/regime.hpp"
#include "own_colliders/own_colliders.hpp"
#include "unit/hints/mistaken_adapters.hpp"

using namespace manifuzz;
using namespace manifuzz::test;

namespace {

Plan plan_of(const Collider& subject, std::uint64_t cases = 6000) {
  Plan plan;
  plan.subject = subject;
  plan.oracle = make_clip64();
  plan.regimes = regimes_for({plan.subject, plan.oracle}, {});
  std::erase_if(plan.regimes, [](const Regime* regime) { return regime->name == "corpus"; });
  narrow_to_colliders(plan);
  plan.seed = 1;
  plan.cases = cases;
  plan.jobs = 2;
  return plan;
}

std::vector<Hint> hints_of_run(const Plan& plan) {
  Interruption interruption;
  const JobsResult run =
      run_jobs(plan, {0, plan.cases_max()}, interruption, [](const Progress&) {});
  return hints_of(*run.tally, plan, interruption);
}

void check_hinted(const std::vector<MistakenAdapter>& adapters) {
  for (const MistakenAdapter& adapter : adapters) {
    DYNAMIC_SECTION(adapter.mistake << ": " << adapter.how) {
      for (const Collider& collider : {adapter.collider, without_names(adapter.collider)}) {
        const std::vector<Hint> hints = hints_of_run(plan_of(collider));
        REQUIRE(!hints.empty());
        UNSCOPED_INFO(hints[0].text);
        CHECK(hints[0].mistake == adapter.mistake);
        CHECK(hints.size() == 1);
        WARN(adapter.how << " -> " << hints[0].text);
      }
    }
  }
}

}  // namespace

TEST_CASE("a mistake in what an adapter answers is named") {
  check_hinted(mistaken_in_answers());
}

TEST_CASE("a mistake in how an adapter reads or declares is named") {
  check_hinted(mistaken_in_reading());
}

TEST_CASE("right colliders get no hint") {
  for (const Collider& right : {make_clip(), make_clip64(), make_gjk(), make_gjk64()}) {
    INFO(right.declaration.name);
    CHECK(hints_of_run(plan_of(right)).empty());
  }
}
