#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "campaign/in_child.hpp"
#include "canary/search.hpp"
#include "canary/worst_cases.hpp"
#include "corpus/shrink.hpp"
#include "generating/drafts.hpp"
#include "oracle/box2d/box2d.hpp"

// How easy the cases are to believe that planted bugs are shrunk to.

namespace manifuzz::canary {
namespace {

/// How clear a number of shrunk cases are.
struct Clarity {
  int cases = 0;
  int with_odd_numbers = 0;  ///< outside 1e-3 to 1e3
  int near_ties = 0;         ///< the best face leads by less than a thousandth of the size
  int ties = 0;
  double digits = 0;
  double log_lead = 0;
  double log_error = 0;
  double seconds = 0;
  double evaluations = 0;
};

bool has_odd_number(PairCase pair) {
  return !std::ranges::all_of(free_numbers(pair),
                              [](const float* number) { return is_ordinary(*number); });
}

void add(const PairCase& found, const Collider& subject, Clarity& clarity) {
  Interruption interruption;
  const Collider oracle = make_box2d();
  const auto start = std::chrono::steady_clock::now();
  const Shrunk shrunk = shrink_finding(found, subject, oracle, interruption);
  clarity.seconds +=
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  clarity.evaluations += shrunk.evaluations;
  ++clarity.cases;
  if (has_odd_number(shrunk.pair)) ++clarity.with_odd_numbers;
  const double lead = lead_of_best_face(shrunk.pair);
  if (lead == 0) {
    ++clarity.ties;
  } else if (lead < 1e-3) {
    ++clarity.near_ties;
  }
  clarity.log_lead += std::log10(std::max(lead, 1e-8));
  clarity.digits += complexity(shrunk.pair).digits;
  const double error = judge(shrunk.pair, subject, oracle).magnitude;
  clarity.log_error += std::log10(std::clamp(error, 1e-9, 1e9));
}

}  // namespace

TEST_CASE("planted bugs are shrunk to numbers of ordinary size, and again to the same case") {
  int cases = 0;
  int odd = 0;
  for (const PlantedBug& bug : planted_bugs()) {
    if (bug.name != "slab_with_epsilon" && bug.name != "clip_needs_both_outside") continue;
    const Collider subject = bug.collider();
    const Collider oracle = make_box2d();
    Interruption interruption;
    for (const auto& [look, worst] : worst_cases(subject, 1, 3000).by_bucket) {
      INFO(bug.name << ' ' << look);
      const PairCase shrunk = shrink_finding(worst.second, subject, oracle, interruption).pair;
      CHECK(shrink_finding(shrunk, subject, oracle, interruption).pair == shrunk);
      ++cases;
      if (has_odd_number(shrunk)) ++odd;
    }
  }
  CHECK(cases > 10);
  CHECK(10 * odd < cases);  // some faults show at odd sizes alone
}

TEST_CASE("the clarity of what planted bugs are shrunk to", "[.table]") {
  Clarity all;
  std::cout << fmt::format("{:<35} {:>5} {:>5} {:>5} {:>5} {:>7} {:>7} {:>7} {:>7} {:>7}\n", "bug",
                           "cases", "odd", "near", "ties", "lglead", "lgerr", "digits", "evals",
                           "sec");
  const auto row = [](const std::string& name, const Clarity& c) {
    const double n = std::max(c.cases, 1);
    std::cout
        << fmt::format(
               "{:<35} {:>5} {:>5} {:>5} {:>5} {:>7.2f} {:>7.2f} {:>7.1f} {:>7.0f} {:>7.3f}\n",
               name, c.cases, c.with_odd_numbers, c.near_ties, c.ties, c.log_lead / n,
               c.log_error / n, c.digits / n, c.evaluations / n, c.seconds / n)
        << std::flush;
  };
  for (const PlantedBug& bug : planted_bugs()) {
    if (!bug.collider || is_unedited(bug) || bug.in_kernel) continue;
    const Collider subject = bug.collider();
    Clarity clarity;
    int findings = 0;
    for (const auto& [look, worst] : worst_cases(subject, 1, 3000).by_bucket) {
      if (++findings > 8) break;
      add(worst.second, subject, clarity);
    }
    row(bug.name, clarity);
    all.cases += clarity.cases;
    all.with_odd_numbers += clarity.with_odd_numbers;
    all.near_ties += clarity.near_ties;
    all.ties += clarity.ties;
    all.digits += clarity.digits;
    all.log_lead += clarity.log_lead;
    all.log_error += clarity.log_error;
    all.seconds += clarity.seconds;
    all.evaluations += clarity.evaluations;
  }
  row("all", all);
}

}  // namespace manifuzz::canary
