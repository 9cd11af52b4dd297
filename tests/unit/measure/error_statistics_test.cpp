#include <catch2/catch.hpp>

#include "measure/referee.hpp"
#include "measure/stress/stress.hpp"

namespace manifuzz {
namespace {

Measured contact(double error) {
  return {.has_errors = true,
          .of_size = {.normal = 0, .position = 2 * error, .depth = error},
          .of_bound = {.normal = 1, .position = 1, .depth = 1},
          .of_extent = 3};
}

Measured of(Assessment assessment, float wrongness = 0) {
  Measured measured;
  measured.assessment = assessment;
  measured.wrongness = wrongness;
  return measured;
}

/// So many contacts with an error of depth, and so many wrong ones.
StepStatistics step(int contacts, double error, int wrong) {
  ErrorCollector collector;
  for (int i = 0; i < contacts; ++i) collector.add(i, contact(error));
  for (int i = 0; i < wrong; ++i) collector.add(contacts + i, of(Assessment::missed));
  return {collector.statistics(), {}};
}

}  // namespace

TEST_CASE("a spread is made of the values themselves") {
  ErrorCollector collector;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    collector.add(i, contact(static_cast<double>((i * 7) % 2000)));
  }
  const ErrorStatistics statistics = collector.statistics();
  CHECK(statistics.cases == 2000);
  CHECK(statistics.contacts == 2000);
  CHECK(statistics.of_size.depth.median == 999);
  CHECK(statistics.of_size.depth.p999 == 1997);
  CHECK(statistics.of_size.depth.max == 1999);
  CHECK((statistics.of_size.depth.worst * 7) % 2000 == 1999);
  CHECK(statistics.of_size.position.max == 2 * 1999);
  CHECK(statistics.of_extent.median == 3);
}

TEST_CASE("every assessment is counted, and the worst wrong case kept") {
  ErrorCollector collector;
  collector.add(0, of(Assessment::unsupported));
  collector.add(1, of(Assessment::ill_posed));
  collector.add(2, of(Assessment::right));
  collector.add(3, of(Assessment::missed, 0));
  collector.add(4, of(Assessment::phantom, 0.5F));
  collector.add(5, of(Assessment::wrong_count, 0.25F));
  collector.add(6, of(Assessment::gross, 0.5F));
  const ErrorStatistics statistics = collector.statistics();
  CHECK(statistics.well_posed() == 5);
  CHECK(statistics.wrong() == 4);
  CHECK(statistics.missed == 1);
  CHECK(statistics.phantom == 1);
  CHECK(statistics.wrong_count == 1);
  CHECK(statistics.gross == 1);
  CHECK(statistics.worst_wrong == 4);
  CHECK(statistics.wrongness == 0.5F);
  collector.add(7, of(Assessment::lost, 1));
  CHECK(collector.statistics().lost == 1);
  CHECK(collector.statistics().worst_wrong == 7);
}

TEST_CASE("a step breaks where one case in ten thousand is wrong") {
  CHECK_FALSE(is_broken(step(100'000, 0, 9)));
  CHECK(is_broken(step(100'000 - 10, 0, 10)));
  CHECK(is_broken(step(1000, 0, 1)));
  CHECK_FALSE(is_broken(step(20'000, 0, 1)));
  CHECK_FALSE(is_broken(step(0, 0, 0)));
}

TEST_CASE("a step breaks where the 99.9th percentile of an error exceeds 1%") {
  CHECK_FALSE(is_broken(step(100, 0.005, 0)));  // the position's is twice that
  CHECK(is_broken(step(100, 0.0051, 0)));
  ErrorCollector rare;
  for (std::uint64_t i = 0; i < 10'000; ++i) rare.add(i, contact(i < 10 ? 1.0 : 0.0));
  CHECK_FALSE(is_broken(rare.statistics()));
  rare.add(10'000, contact(1));
  CHECK(is_broken(rare.statistics()));
  StepStatistics normal = step(100, 0, 0);
  normal.of_size.normal.p999 = 0.02;
  CHECK(is_broken(normal));
}

TEST_CASE("ill-posed and unsupported cases do not count") {
  ErrorCollector collector;
  for (std::uint64_t i = 0; i < 5000; ++i) collector.add(i, of(Assessment::ill_posed));
  for (std::uint64_t i = 0; i < 5000; ++i) collector.add(i, of(Assessment::unsupported));
  CHECK_FALSE(is_broken(collector.statistics()));
  collector.add(10'000, of(Assessment::gross));
  CHECK(is_broken(collector.statistics()));
}

TEST_CASE("the breaking point is the first broken step") {
  const StepStatistics good = step(100, 0, 0);
  const StepStatistics bad = step(100, 0, 1);
  CHECK_FALSE(breaking_step(std::vector{good, good}));
  CHECK(breaking_step(std::vector{good, bad, good, bad}) == 1);
  CHECK_FALSE(breaking_step({}));
}

TEST_CASE("errors that are only counted leave counts alone") {
  ErrorCollector collector(ErrorCollector::Errors::counted);
  collector.add(0, contact(1));
  CHECK(collector.statistics().contacts == 1);
  CHECK(collector.statistics().of_size.depth.max <= 0);
}

}  // namespace manifuzz
