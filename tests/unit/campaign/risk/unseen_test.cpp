#include "campaign/risk/unseen.hpp"

#include <array>

#include <catch2/catch.hpp>

#include "campaign/risk/risk.hpp"

using namespace manifuzz;

namespace {

/// All cases are judged.
Chance of_one(std::uint64_t judged, std::uint64_t once, std::uint64_t twice,
              double error = kRiskError) {
  return chance_of_unseen(std::array{Stratum{judged, judged, once, twice}}, error);
}

void check_chance(const Chance& chance, double next, double low, double high) {
  CHECK(chance.next == Approx(next).epsilon(1e-7));
  CHECK(chance.low == Approx(low).margin(1e-12).epsilon(1e-7));
  CHECK(chance.high == Approx(high).epsilon(1e-7));
}

}  // namespace

TEST_CASE("where nothing was met once or twice, the next is unseen in at most 3.7 / n") {
  check_chance(of_one(1000, 0, 0), 0, 0, 3.68887945e-3);  // -ln 0.025
  check_chance(of_one(1, 0, 0), 0, 0, 1);
}

TEST_CASE("the interval is Esty's, with 2 more, or Poisson's where that is wider") {
  // 1.95996398 times the root of 10 + 2 5 + 2 is 9.19304596.
  check_chance(of_one(1000, 10, 5), 0.01, (10 - 9.19304596) / 1000, (10 + 9.19304596) / 1000);
  // The root of 100 + 2 is less than Poisson's reach upwards, and more than that downwards.
  check_chance(of_one(1000, 100, 0), 0.1, (100 - 19.79466587) / 1000, 0.12162679);
  // The exponential of -857 is below every double.
  check_chance(of_one(100'000, 800, 0), 8e-3, 7.44494595e-3, 8.57411783e-3);
}

TEST_CASE("one look of many misses less often, and is the wider") {
  CHECK(error_of_look(1) == 0.025);
  CHECK(error_of_look(14) == Approx(0.05 / 210));
  double sum = 0;
  for (std::uint64_t look = 1; look <= 1000; ++look) sum += error_of_look(look);
  CHECK(sum < 0.05);
  CHECK(sum > 0.0499);
  check_chance(of_one(1000, 0, 0, error_of_look(14)), 0, 0, 9.0359871e-3);  // -ln (0.05 / 420)
}

TEST_CASE("parts are weighted by their cases, each at half the error") {
  const std::array parts{Stratum{9000, 9000, 10, 5}, Stratum{1000, 10, 0, 0}};
  // 2.24140273 times the root of 22 is 10.51311068, and -ln 0.0125 is 4.38202663.
  check_chance(chance_of_unseen(parts, 0.05), 0.9 * 10 / 9000, 0,
               0.9 * (10 + 10.51311068) / 9000 + 0.1 * 4.38202663 / 10);
  const std::array one_met{Stratum{9000, 9000, 0, 0}, Stratum{1000, 10, 1, 0}};
  CHECK(chance_of_unseen(one_met, 0.05).next == Approx(0.1 / 10));
}

TEST_CASE(
    "a part without cases takes no share of the error, one without judged cases may be all new") {
  check_chance(chance_of_unseen(std::array{Stratum{1000, 1000, 0, 0}, Stratum{}}, 0.05), 0, 0,
               3.68887945e-3);
  check_chance(chance_of_unseen(std::array{Stratum{900, 900, 0, 0}, Stratum{100, 0, 0, 0}}, 0.05),
               0, 0, 0.9 * 4.38202663 / 900 + 0.1);
  check_chance(chance_of_unseen(std::array{Stratum{}, Stratum{}}, 0.05), 0, 0, 1);
}
