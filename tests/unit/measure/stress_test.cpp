#include "measure/stress/stress.hpp"

#include <unistd.h>

#include <catch2/catch.hpp>

#include "base/text.hpp"
#include "own_colliders/own_colliders.hpp"

namespace manifuzz {
namespace {

constexpr int kDeath = 9;  // not by a signal, which the test framework would catch

StressSubject subject(const Collider& collider) {
  return {collider.declaration.name, collider};
}

StressPlan small_plan() {
  StressPlan plan;
  plan.sweeps = {find_by_name(sweeps(), "distance"), find_by_name(sweeps(), "collinear")};
  plan.walks = {find_by_name(walks(), "sliding")};
  plan.subjects = {ideal_subject(), subject(make_clip()), subject(make_batch()),
                   subject(make_clip64())};
  plan.subjects.push_back({"clip with a bias", make_clip(kWalkBias), true});
  plan.cases = 300;
  plan.frames = 1000;
  return plan;
}

StressResult run(const StressPlan& plan) {
  Interruption interruption;
  return run_stress(plan, interruption, [](const StressProgress&) {});
}

/// `clip`, but for what it does to one case in so many.
StressSubject spoilt(const std::string& name, const std::function<void(const PairCase&)>& spoil) {
  Collider collider = make_clip();
  collider.declaration.name = name;
  collider.collide = [clip = make_clip(), spoil](const PairCase& pair) {
    spoil(pair);
    return clip.collide(pair);
  };
  return {name, collider};
}

/// Whether the case is the one of a step that a planted collider dies of.
bool is_fatal(const PairCase& pair, std::uint64_t index) {
  const Sweep& sweep = *find_by_name(sweeps(), "touch");
  return pair == draw_case(1, sweep, sweep.values[1], index);
}

}  // namespace

TEST_CASE("what is measured does not depend on the number of jobs") {
  StressPlan plan = small_plan();
  const StressResult one = run(plan);
  plan.jobs = 3;
  CHECK(one.tallies == run(plan).tallies);
  plan.seed = 2;
  CHECK_FALSE(one.tallies == run(plan).tallies);
}

TEST_CASE("every unit is measured, and colliders that answer alike have the same errors") {
  const StressPlan plan = small_plan();
  const StressResult result = run(plan);
  CHECK(result.units.size() == units_of(plan).size());
  CHECK_FALSE(result.interrupted);
  const auto steps = result.steps(*plan.sweeps[0], 1);
  REQUIRE(steps.size() == plan.sweeps[0]->values.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const StepStatistics of_batch = result.steps(*plan.sweeps[0], 2)[i];
    CHECK(steps[i].cases == 300);
    CHECK(steps[i].of_size.position.max == of_batch.of_size.position.max);
    const StepStatistics of_double = result.steps(*plan.sweeps[0], 3)[i];
    CHECK(of_double.of_size.depth.p999 < steps[i].of_size.depth.p999);
    CHECK(result.steps(*plan.sweeps[0], 0)[i].of_extent.max <= 1);
  }
  CHECK(result.walk(*plan.walks[0], 1)->cases == 1000);
  CHECK(result.walk(*plan.walks[0], 4)->cases == 1000);
  CHECK(result.steps(*plan.sweeps[0], 4)[0].cases == 0);  // for walks alone
}

TEST_CASE("a collider that dies loses the case, and nobody else does") {
  StressPlan plan;
  plan.sweeps = {find_by_name(sweeps(), "touch")};
  plan.cases = 300;
  plan.subjects = {subject(make_clip()), spoilt("dies", [](const PairCase& pair) {
                     if (is_fatal(pair, 7) || is_fatal(pair, 260)) _exit(kDeath);
                   })};
  const StressResult result = run(plan);
  const auto of_clip = result.steps(*plan.sweeps[0], 0);
  const auto of_other = result.steps(*plan.sweeps[0], 1);
  REQUIRE(of_other.size() == of_clip.size());
  for (std::size_t i = 0; i < of_clip.size(); ++i) {
    CHECK(of_clip[i].lost == 0);
    CHECK(of_clip[i].cases == 300);
    CHECK(of_other[i].lost == (i == 1 ? 2 : 0));
    CHECK(of_other[i].cases == 300);
  }
  CHECK(of_other[1].worst_wrong == 7);
}

TEST_CASE("one that does nothing but die has lost the rest of the step, soon") {
  StressPlan plan;
  plan.sweeps = {find_by_name(sweeps(), "off_unit")};
  plan.cases = 400;
  plan.jobs = 2;
  plan.subjects = {spoilt("dies", [](const PairCase&) { _exit(kDeath); }), subject(make_clip())};
  const StressResult result = run(plan);
  for (const StepStatistics& step : result.steps(*plan.sweeps[0], 0)) CHECK(step.lost == 400);
  for (const StepStatistics& step : result.steps(*plan.sweeps[0], 1)) CHECK(step.lost == 0);
}

TEST_CASE("one that dies again and again is given up, in whatever order its deaths come") {
  LostCases onward;
  for (std::uint64_t i = 1; i <= kLostMax; ++i) onward.add(10 * i);
  CHECK(onward.has(10));
  CHECK_FALSE(onward.has(11));
  CHECK(onward.has(10 * kLostMax + 1));
  LostCases backward;
  for (std::uint64_t i = 0; i < kLostMax; ++i) backward.add(1000 - i);
  CHECK_FALSE(backward.has(5));
  backward.add(5);
  CHECK(backward.has(0));
  CHECK(backward.count == kLostMax);
}

TEST_CASE("nonsense is counted") {
  StressPlan plan;
  plan.sweeps = {find_by_name(sweeps(), "tie")};
  plan.cases = 50;
  StressSubject fool = subject(make_clip());
  fool.collider.collide = [](const PairCase&) {
    Manifold<double> manifold;
    manifold.count = 7;
    return manifold;
  };
  plan.subjects = {fool};
  for (const StepStatistics& step : run(plan).steps(*plan.sweeps[0], 0)) CHECK(step.lost == 50);
}

TEST_CASE("a unit's case is the one that was measured") {
  const StressPlan plan = small_plan();
  const Unit step{.sweep = plan.sweeps[0], .step = 3};
  CHECK(case_of(plan, step, 5) == draw_case(1, *plan.sweeps[0], plan.sweeps[0]->values[3], 5));
  const Unit walk{.walk = plan.walks[0]};
  CHECK(case_of(plan, walk, 5) == frame_of(1, *plan.walks[0], 5));
}

}  // namespace manifuzz
