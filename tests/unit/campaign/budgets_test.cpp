#include <algorithm>

#include <catch2/catch.hpp>

#include "campaign/result.hpp"
#include "generating/regime.hpp"

using namespace manifuzz;

namespace {

Plan plan_of(std::string_view regime) {
  Plan plan;
  plan.oracle.declaration.name = "box2d";
  plan.regimes.push_back(find_regime(regime));
  return plan;
}

std::size_t entries_over_budget(std::string_view regime, std::uint64_t cases, std::uint64_t hits) {
  Tally tally;
  tally.regimes[0].cases = cases;
  for (auto& of_entry : tally.explained) of_entry[0] = hits;
  std::size_t over = 0;
  for (const LedgerResult& count : ledger_counts(tally, plan_of(regime))) {
    if (!count.over_budget.empty()) ++over;
  }
  return over;
}

std::size_t entries_of_box2d() {
  return static_cast<std::size_t>(
      std::ranges::count(ledger(), std::string_view("box2d"), &LedgerEntry::collider));
}

}  // namespace

TEST_CASE("an entry that fires too often in a regime is over its budget") {
  CHECK(entries_over_budget("separated", 1'000'000, 0) == 0);
  CHECK(entries_over_budget("separated", 1'000'000, 100) == entries_of_box2d());
  CHECK(entries_over_budget("generic", 1'000'000, 20) == entries_of_box2d() - 1);  // the bias may
  CHECK(entries_over_budget("generic", 1'000, 3) == 0);                            // chance
}

TEST_CASE("a plan with radii of its own is not held to budgets") {
  Tally tally;
  tally.regimes[0].cases = 1000;
  tally.explained[0][0] = 1000;
  Plan plan = plan_of("separated");
  CHECK_FALSE(ledger_counts(tally, plan)[0].over_budget.empty());
  plan.context.radius = 0.0F;
  CHECK(ledger_counts(tally, plan)[0].over_budget.empty());
}

TEST_CASE("the regime corpus, which depends on the corpus, is not held to budgets") {
  CHECK(entries_over_budget("corpus", 1000, 1000) == 0);
}

TEST_CASE("every budget names a regime, and not the regime corpus") {
  int budgets = 0;
  for (const LedgerEntry& entry : ledger()) {
    for (const Budget& budget : entry.budgets) {
      ++budgets;
      CHECK(find_regime(budget.regime) != nullptr);
      CHECK(budget.regime != "corpus");
    }
  }
  CHECK(budgets > 10);
}
