#include <catch2/catch.hpp>

#include "campaign/accept.hpp"
#include "campaign/known.hpp"
#include "generating/regime.hpp"

// What is accepted of a finding, component by component.

using namespace manifuzz;
using Catch::Contains;

namespace {

const std::string kToday = "2026-11-23";
const std::string kGross = "subject/subject_wrong/depth/none/a/gross";

CorpusCase wrong(const std::string& bucket) {
  CorpusCase known;
  known.expect = Expectation{"mine", "box2d", "subject_wrong", bucket, {}};
  known.expect->magnitude = 0.25;
  known.path = bucket + ".json";
  return known;
}

}  // namespace

TEST_CASE("each component is accepted up to its own limit, and one that is not named not at all") {
  Acceptance acceptance{.because = "so"};
  acceptance.errors_up_to.emplace()[Component::position] = 0.5;
  const auto objection_to = [&](Component component, double error) {
    WorstError worst{.magnitude = error};
    worst.errors[component] = error;
    return objection(acceptance, worst, kToday);
  };
  CHECK(objection_to(Component::position, 0.5).empty());
  CHECK_THAT(objection_to(Component::position, 0.6),
             Contains("worse than is accepted: position 0.6 of the size, above 0.5"));
  CHECK_THAT(objection_to(Component::depth, 1e-9), Contains("depth 1e-09 of the size, above 0"));
  CHECK(objection(acceptance, {}, kToday).empty());  // within its bounds it is no error
}

TEST_CASE("what is accepted are the components that were seen, each three times its worst") {
  CorpusCase known = wrong(kGross);
  known.expect->errors.emplace()[Component::position] = 0.25;
  CHECK((*acceptance_of(known, {.because = "so"}).errors_up_to)[Component::position] == 0.75);
  known.found = Found{1, "boxes", 2, {}};
  known.found->seen = Seen{1'000'000, 0.5, {{"boxes", 100}}};
  known.found->seen->errors.emplace()[Component::position] = 0.5;
  (*known.found->seen->errors)[Component::depth] = 0.125;
  const Acceptance of_campaign = acceptance_of(known, {.because = "so"});
  CHECK_FALSE(of_campaign.up_to);
  CHECK((*of_campaign.errors_up_to)[Component::position] == 1.5);
  CHECK((*of_campaign.errors_up_to)[Component::depth] == 0.375);
  CHECK((*of_campaign.errors_up_to)[Component::missing] == 0);
  const Acceptance asked = acceptance_of(known, {.because = "so", .up_to = 8});
  CHECK((*asked.errors_up_to)[Component::depth] == 8);
  CHECK((*asked.errors_up_to)[Component::excess] == 0);
}

TEST_CASE("a component that grows beneath the others is new, by the case that shows it") {
  CorpusCase known = wrong(kGross);
  known.accepted = Acceptance{.because = "so"};
  known.accepted->errors_up_to.emplace()[Component::position] = 100;
  Plan plan;
  plan.subject.declaration.name = "mine";
  plan.oracle.declaration.name = "box2d";
  plan.regimes = {find_regime("boxes")};
  Tally tally;
  tally.regimes[0].cases = 1000;
  BucketTally& met = tally.buckets.of(*find_bucket(kGross));
  met.count = met.regimes[0] = 20;
  met.error.magnitude = 50;
  met.error.errors[Component::position] = 50;
  met.error.errors[Component::depth] = 1e-3;
  met.worst = 4;
  met.worst_of[static_cast<std::size_t>(Component::depth)] = 6;
  const auto all = findings(tally, plan, known_of({&known, 1}, kToday));
  REQUIRE(all.size() == 1);
  CHECK(all.front().is_new);
  CHECK_FALSE(all.front().is_accepted);
  CHECK_THAT(all.front().objection, Contains("depth 0.001"));
  CHECK(all.front().tally.worst == 6);
}
