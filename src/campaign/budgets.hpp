#pragma once

#include <string>
#include <vector>

#include "campaign/plan.hpp"

namespace manifuzz {

/// What an entry of the ledger did in a campaign.
struct LedgerCount {
  const LedgerEntry* entry = nullptr;
  std::uint64_t hits = 0;
  std::vector<std::string> over_budget;  ///< the regimes in which it fired too often
};

/// Every entry of the plan's oracle. Budgets hold for the regimes as they are, as far as the
/// colliders take them: a plan with radii of its own is not held to them, nor is the regime
/// `corpus`, which hangs on what the corpus holds. Five standard deviations are chance.
std::vector<LedgerCount> ledger_counts(const Tally& tally, const Plan& plan);

}  // namespace manifuzz
