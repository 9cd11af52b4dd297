#include "campaign/budgets.hpp"

#include <cmath>

namespace manifuzz {

bool holds_budgets(const Plan& plan) {
  return !plan.context.radius || plan.is_narrowed;
}

bool is_over_budget(const LedgerEntry& entry, std::string_view regime, std::uint64_t hits,
                    std::uint64_t cases) {
  if (regime == "corpus") return false;
  const double expected = budget_per_million(entry, regime) * 1e-6 * static_cast<double>(cases);
  return static_cast<double>(hits) > expected + 5 * std::sqrt(expected) + 5;
}

std::vector<LedgerResult> ledger_counts(const Tally& tally, const Plan& plan) {
  std::vector<LedgerResult> counts;
  for (const LedgerEntry& entry : ledger()) {
    if (entry.collider != plan.oracle.declaration.name) continue;
    LedgerResult count{std::string(entry.id), 0, {}, {}};
    for (std::size_t r = 0; r < plan.regimes.size(); ++r) {
      const std::uint64_t hits = tally.explained[index_of(entry)][r];
      count.hits += hits;
      const std::string regime(plan.regimes[r]->name);
      if (hits > 0) count.regimes[regime] = hits;
      if (holds_budgets(plan) && is_over_budget(entry, regime, hits, tally.regimes[r].cases)) {
        count.over_budget.push_back(regime);
      }
    }
    counts.push_back(count);
  }
  return counts;
}

}  // namespace manifuzz
