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
        CHECK(hints[0].right_when_undone >= 50);
        CHECK(hints.size() == 1);
      }
    }
  }
}

}  // namespace

TEST_CASE("a mistake in what an adapter answers is named", "[longer]") {
  check_hinted(mistaken_in_answers());
}

TEST_CASE("a mistake in how an adapter reads or declares is named", "[longer]") {
  check_hinted(mistaken_in_reading());
}

TEST_CASE("right colliders get no hint") {
  for (const Collider& right : {make_clip(), make_clip64(), make_gjk(), make_gjk64()}) {
    INFO(right.declaration.name);
    CHECK(hints_of_run(plan_of(right)).empty());
  }
}

TEST_CASE("too few wrong answers get no hint") {
  const MistakenAdapter reversed = mistaken_in_answers().front();
  CHECK(hints_of_run(plan_of(reversed.collider, 20)).empty());
}

TEST_CASE("hints are the same of any number of jobs") {
  for (const MistakenAdapter& adapter : mistaken_in_answers()) {
    if (adapter.mistake != "y-down") continue;
    Plan plan = plan_of(adapter.collider, 2000);
    const std::vector<Hint> of_two = hints_of_run(plan);
    REQUIRE(of_two.size() == 1);
    plan.jobs = 1;
    CHECK(hints_of_run(plan) == of_two);
  }
}

TEST_CASE("a mistake and a bug of another kind give a hint of the mistake alone") {
  // Every third contact lacks its second point, too.
  Collider collider = mistaken_in_answers().front().collider;
  collider.collide = [reversed = collider.collide](const PairCase& pair) {
    auto manifold = std::get<Manifold<double>>(reversed(pair));
    if (manifold.count == 2 && pair.a.polygon.count % 3 == 0) manifold.count = 0;
    return Answer(manifold);
  };
  const std::vector<Hint> hints = hints_of_run(plan_of(collider));
  REQUIRE(hints.size() == 1);
  CHECK(hints[0].mistake == "reversed-normal");
}

TEST_CASE("the least cases are kept in whatever order they come") {
  LeastCases one;
  LeastCases other;
  for (std::uint64_t number = 1000; number > 0; --number) {
    (number % 2 == 0 ? one : other).add(number);
    one.add(7 * number);
  }
  one.add(other);
  REQUIRE(one.all().size() == LeastCases::kRoom);
  for (std::uint64_t i = 0; i < one.all().size(); ++i) CHECK(one.all()[i] == i + 1);
}
