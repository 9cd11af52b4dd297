#include <array>
#include <map>
#include <tuple>

#include <catch2/catch.hpp>

#include "campaign/risk/risk.hpp"
#include "unit/campaign/risk/simulated.hpp"

using namespace manifuzz;
using namespace manifuzz::test;

namespace {

constexpr int kRuns = 2000;
constexpr double kHeldLeast = 0.94;

/// Intervals by what they follow from: many runs have the same.
class Intervals {
 public:
  explicit Intervals(double error) : error_(error) {}
  Chance of(const std::array<Stratum, 2>& strata) {
    const auto& [always, agreed] = strata;
    const std::array key{always.cases, always.once, always.twice, agreed.once, agreed.twice};
    const auto [found, is_new] = known_.try_emplace(key);
    if (is_new) found->second = chance_of_unseen(strata, error_);
    return found->second;
  }

 private:
  double error_;
  std::map<std::array<std::uint64_t, 5>, Chance> known_{};
};

bool holds(const Chance& chance, double unseen) {
  return chance.low <= unseen && unseen <= chance.high;
}

struct Coverage {
  double held = 0;    ///< the share of runs in which the interval holds
  double next = 0;    ///< the mean of what is said
  double unseen = 0;  ///< the mean of what is true
};

Coverage coverage_of(const Law& law, double cases, double judge_every) {
  SimulatedRow row(law, cases, judge_every);
  Intervals intervals(kRiskError);
  Coverage sum;
  for (int run = 0; run < kRuns; ++run) {
    Random random(3, law.name, static_cast<std::uint64_t>(run));
    row.clear();
    row.run(random);
    const Chance chance = intervals.of(row.strata());
    sum.held += holds(chance, row.unseen()) ? 1.0 / kRuns : 0;
    sum.next += chance.next / kRuns;
    sum.unseen += row.unseen() / kRuns;
  }
  return sum;
}

void check_coverage(const Law& law, double cases, double judge_every) {
  const Coverage coverage = coverage_of(law, cases, judge_every);
  CAPTURE(law.name, cases, judge_every, coverage.held, coverage.next, coverage.unseen);
  CHECK(coverage.held >= kHeldLeast);
  CHECK(coverage.next == Approx(coverage.unseen).epsilon(0.15).margin(0.5 / cases * judge_every));
}

/// Laws of which some buckets come with agreed contacts too, and others only so.
std::vector<Law> laws_of_two_parts() {
  std::vector<Law> laws = known_laws();
  for (Law& law : laws) {
    law.agreed_share = 0.6;
    for (std::size_t i = 0; i < law.always.size(); ++i) {
      law.agreed.push_back(i % 3 == 0 ? 0 : law.always[i] / 20);
      law.always[i] *= i % 3 == 1 ? 0 : 0.9;
    }
  }
  return laws;
}

}  // namespace

TEST_CASE("the interval holds in at least 94% of campaigns of known laws") {
  for (const Law& law : known_laws()) {
    for (const double cases : {1'000, 5'000, 20'000, 100'000, 400'000}) {
      check_coverage(law, cases, 1);
    }
  }
}

TEST_CASE("the interval holds where a few rare buckets are all there is") {
  for (const int buckets : {1, 2, 5, 20}) {
    for (const double mean : {0.3, 1.0, 2.0, 3.5, 5.0}) {
      const Law law{"few", std::vector<double>(static_cast<std::size_t>(buckets), mean / 10'000)};
      check_coverage(law, 10'000, 1);
    }
  }
}

TEST_CASE("the interval holds where of agreed contacts only a sample is judged") {
  for (const Law& law : laws_of_two_parts()) {
    for (const double cases : {5'000, 100'000, 2'000'000}) {
      for (const double judge_every : {8, 256}) check_coverage(law, cases, judge_every);
    }
  }
}

TEST_CASE("all looks at a campaign that goes on hold together in at least 94%", "[longer]") {
  constexpr int kLooks = 6;
  for (const Law& law : laws_of_two_parts()) {
    SimulatedRow row(law, 1024, 8);
    std::vector<Intervals> intervals;
    for (std::uint64_t look = 1; look <= kLooks; ++look) {
      intervals.emplace_back(error_of_look(look));
    }
    int held = 0;
    for (int run = 0; run < kRuns; ++run) {
      Random random(4, law.name, static_cast<std::uint64_t>(run));
      row.clear();
      bool holds_always = true;
      for (int look = 0, times = 0; look < kLooks; ++look) {
        for (; times < 1 << look; ++times) row.run(random);
        holds_always = holds_always && holds(intervals[look].of(row.strata()), row.unseen());
      }
      held += holds_always ? 1 : 0;
    }
    CAPTURE(law.name, held);
    CHECK(held >= kHeldLeast * kRuns);
  }
}
