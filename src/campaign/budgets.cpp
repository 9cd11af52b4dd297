#include "campaign/budgets.hpp"

#include <cmath>

namespace manifuzz {
namespace {

bool is_over(std::uint64_t hits, double expected) {
  return static_cast<double>(hits) > expected + 5 * std::sqrt(expected) + 5;
}

}  // namespace

std::vector<LedgerCount> ledger_counts(const Tally& tally, const Plan& plan) {
  std::vector<LedgerCount> counts;
  for (const LedgerEntry& entry : ledger()) {
    if (entry.collider != plan.oracle.declaration.name) continue;
    LedgerCount count{&entry, 0, {}};
    for (std::size_t r = 0; r < plan.regimes.size(); ++r) {
      const std::uint64_t hits = tally.explained[index_of(entry)][r];
      count.hits += hits;
      const std::string_view regime = plan.regimes[r]->name;
      const double expected =
          budget_per_million(entry, regime) * 1e-6 * static_cast<double>(tally.regimes[r].cases);
      const bool budgeted = (!plan.context.radius || plan.is_narrowed) && regime != "corpus";
      if (budgeted && is_over(hits, expected)) count.over_budget.emplace_back(regime);
    }
    counts.push_back(count);
  }
  return counts;
}

}  // namespace manifuzz
