#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/risk/unseen.hpp"

namespace manifuzz {

struct CampaignResult;
struct Plan;
struct Tally;

// What is left to find. Every bucket but that of an agreement counts: ties, ill-posed and
// unsupported cases show something that was not seen before, too. A wrong bucket has
// somebody at fault, explained by the ledger or not, known to the corpus or not.
//
// A row's cases are of two parts. Where both colliders plainly agree on a contact, one case in
// `judge_every` is judged, and only those can show anything: both wrong alike, say. All others are
// judged, or compared exactly. Where every case is judged, there is one part.
//
// The regime `corpus` has no row, and its cases are not in that of all: what it can show depends on
// what the corpus holds, which earlier campaigns have chosen. `ulp` has one: it moves cases of
// other regimes, never of the corpus. A hunt has no risk: it breeds its cases from others.

/// The chance that an interval misses: it holds in 95%.
inline constexpr double kRiskError = 0.05;

/// The chance that look k, 1, 2, ..., misses, of a campaign that ends by what it sees: all looks
/// together miss with the chance 0.05, since the sum of 1 / (k (k + 1)) is 1.
double error_of_look(std::uint64_t look);

/// The chance that the next case shows a bucket not seen.
struct UnseenRisk : Chance {
  std::uint64_t once = 0;  ///< buckets that were met once
};

/// A regime's, or that of all: then a bucket counts as seen that any regime has shown.
struct RiskRow {
  std::string regime;
  std::uint64_t cases = 0;
  UnseenRisk any;
  UnseenRisk wrong;  ///< a bucket with somebody at fault
};

/// What the row of all regimes is called.
inline constexpr std::string_view kAllRegimes = "all";

/// Whether a bucket has somebody at fault; one that this version does not know may have.
bool is_of_fault(const std::string& bucket);

/// Whether the regime has no row.
bool has_no_risk(std::string_view regime);

/// Throws UserError that names --until-risk where the risk is to end the plan and no regime has
/// one.
void expect_risk(const Plan& plan);

/// A row for each regime, then one for all; none where no regime has one, or where the result is of
/// a version that did not count what is needed.
std::vector<RiskRow> risk_of(const CampaignResult& result);

/// The row of all regimes of a run so far. `error`: the chance that its interval misses.
RiskRow risk_of_all(const Tally& tally, const Plan& plan, double error);

}  // namespace manifuzz
