#pragma once

#include <vector>

#include "campaign/plan.hpp"
#include "campaign/result.hpp"

namespace manifuzz {

/// Budgets hold for the regimes as they are, as far as the colliders take them: a plan with radii
/// of its own is not held to them.
bool holds_budgets(const Plan& plan);

/// Whether an entry fired more often in so many cases of a regime than its budget and five standard
/// deviations of chance allow. The regime `corpus`, which depends on what the corpus holds, has
/// none.
bool is_over_budget(const LedgerEntry& entry, std::string_view regime, std::uint64_t hits,
                    std::uint64_t cases);

/// Every entry of the plan's oracle.
std::vector<LedgerResult> ledger_counts(const Tally& tally, const Plan& plan);

}  // namespace manifuzz
