#include "measure/stress/step_tally.hpp"

#include <catch2/catch.hpp>

namespace manifuzz {
namespace {

Measured contact(float error) {
  return {.has_errors = true,
          .of_size = {.depth = error, .position = 2 * error, .normal = 0},
          .of_bound = {.depth = 1, .position = 1, .normal = 1},
          .of_extent = 3};
}

Measured of(Assessment assessment, float wrongness = 0) {
  Measured measured;
  measured.assessment = assessment;
  measured.wrongness = wrongness;
  return measured;
}

/// So many contacts with an error of depth, and so many wrong ones.
StepTally step(int contacts, float error, int wrong) {
  StepCollector collector;
  for (int i = 0; i < contacts; ++i) collector.add(i, contact(error));
  for (int i = 0; i < wrong; ++i) collector.add(contacts + i, of(Assessment::missed));
  return collector.tally();
}

}  // namespace

TEST_CASE("a spread is made of the values themselves") {
  StepCollector collector;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    collector.add(i, contact(static_cast<float>((i * 7) % 2000)));
  }
  const StepTally tally = collector.tally();
  CHECK(tally.cases == 2000);
  CHECK(tally.contacts == 2000);
  CHECK(tally.of_size.depth.median == 999);
  CHECK(tally.of_size.depth.p999 == 1997);
  CHECK(tally.of_size.depth.max == 1999);
  CHECK((tally.of_size.depth.worst * 7) % 2000 == 1999);
  CHECK(tally.of_size.position.max == 2 * 1999);
  CHECK(tally.of_extent.median == 3);
}

TEST_CASE("every assessment is counted, and the worst wrong case kept") {
  StepCollector collector;
  collector.add(0, of(Assessment::unsupported));
  collector.add(1, of(Assessment::ill_posed));
  collector.add(2, of(Assessment::right));
  collector.add(3, of(Assessment::missed, 0));
  collector.add(4, of(Assessment::phantom, 0.5F));
  collector.add(5, of(Assessment::wrong_count, 0.25F));
  collector.add(6, of(Assessment::gross, 0.5F));
  const StepTally tally = collector.tally();
  CHECK(tally.well_posed() == 5);
  CHECK(tally.wrong() == 4);
  CHECK(tally.missed == 1);
  CHECK(tally.phantom == 1);
  CHECK(tally.wrong_count == 1);
  CHECK(tally.gross == 1);
  CHECK(tally.worst_wrong == 4);
  CHECK(tally.wrongness == 0.5F);
  collector.add(7, of(Assessment::lost, 1));
  CHECK(collector.tally().lost == 1);
  CHECK(collector.tally().worst_wrong == 7);
}

TEST_CASE("a step breaks where one case in ten thousand is wrong") {
  CHECK_FALSE(is_broken(step(100'000, 0, 9)));
  CHECK(is_broken(step(100'000 - 10, 0, 10)));
  CHECK(is_broken(step(1000, 0, 1)));
  CHECK_FALSE(is_broken(step(20'000, 0, 1)));
  CHECK_FALSE(is_broken(step(0, 0, 0)));
}

TEST_CASE("a step breaks where the 99.9th percentile of an error exceeds 1%") {
  CHECK_FALSE(is_broken(step(100, 0.005F, 0)));  // the position's is twice that
  CHECK(is_broken(step(100, 0.0051F, 0)));
  StepCollector rare;
  for (std::uint64_t i = 0; i < 10'000; ++i) rare.add(i, contact(i < 10 ? 1.0F : 0.0F));
  CHECK_FALSE(is_broken(rare.tally()));
  rare.add(10'000, contact(1));
  CHECK(is_broken(rare.tally()));
  StepTally normal = step(100, 0, 0);
  normal.of_size.normal.p999 = 0.02F;
  CHECK(is_broken(normal));
}

TEST_CASE("ill-posed and unsupported cases do not count") {
  StepCollector collector;
  for (std::uint64_t i = 0; i < 5000; ++i) collector.add(i, of(Assessment::ill_posed));
  for (std::uint64_t i = 0; i < 5000; ++i) collector.add(i, of(Assessment::unsupported));
  CHECK_FALSE(is_broken(collector.tally()));
  collector.add(10'000, of(Assessment::gross));
  CHECK(is_broken(collector.tally()));
}

TEST_CASE("the breaking point is the first broken step") {
  const StepTally good = step(100, 0, 0);
  const StepTally bad = step(100, 0, 1);
  CHECK_FALSE(breaking_step(std::vector{good, good}));
  CHECK(breaking_step(std::vector{good, bad, good, bad}) == 1);
  CHECK_FALSE(breaking_step({}));
}

TEST_CASE("errors that are only counted leave counts alone") {
  StepCollector collector(StepCollector::Errors::counted);
  collector.add(0, contact(1));
  CHECK(collector.tally().contacts == 1);
  CHECK(collector.tally().of_size.depth.max <= 0);
}

}  // namespace manifuzz
