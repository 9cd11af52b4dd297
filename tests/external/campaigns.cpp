#include "external/campaigns.hpp"

#include <catch2/catch.hpp>

#include "external/behaviour.hpp"
#include "generating/regime.hpp"
#include "own_colliders/own_colliders.hpp"

namespace manifuzz::test {

Collider library() {
  return collider_in_own_process(MANIFUZZ_TEST_LIBRARY, kSecondsMax);
}

Collider program(const std::string& behaviour) {
  return collider_of_command(MANIFUZZ_TEST_PROGRAM " " + behaviour, kSecondsMax);
}

Plan plan_of(const Collider& subject) {
  Plan plan;
  plan.subject = subject;
  plan.oracle = make_clip64();
  plan.regimes = {find_regime("generic"), find_regime("sliver")};
  plan.seed = 3;
  plan.cases = kCases;
  plan.jobs = 2;
  return plan;
}

JobsResult run(const Plan& plan) {
  Interruption interruption;
  return run_jobs(plan, {0, plan.cases_max()}, interruption, [](const Progress&) {});
}

std::uint64_t unlucky(const Plan& plan) {
  std::uint64_t count = 0;
  for (CaseNumber number = 0; number < *plan.cases; ++number) {
    const PairCase pair = plan.pair(number);
    const float x = pair.a.polygon.vertices[0].x();
    if (is_unlucky(x, pair.b.pose.position.y())) ++count;
  }
  return count;
}

void check_loses(const Collider& subject, Verdict verdict) {
  const Plan plan = plan_of(subject);
  const std::uint64_t expected = unlucky(plan);
  REQUIRE(expected > 0);
  const JobsResult result = run(plan);
  CHECK(result.tally->cases() == kCases);
  CHECK(result.tally->count(verdict) == expected);
  CHECK(result.tally->unexplained() == expected);
  const BucketTally* const lost =
      result.tally->buckets.find(bucket_of_lost(verdict, Fault::subject));
  REQUIRE(lost != nullptr);
  CHECK(lost->count == expected);
}

std::uint64_t count_of(const JobsResult& result, Kind kind) {
  std::uint64_t count = 0;
  for (const auto& [bucket, tally] : result.tally->buckets.all()) {
    if (bucket.kind == kind) count += tally->count;
  }
  return count;
}

}  // namespace manifuzz::test
