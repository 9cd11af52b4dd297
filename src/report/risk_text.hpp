#pragma once

#include <string>

#include "campaign/run.hpp"

namespace manifuzz {

// What is left to find, for people: chances are numbers of cases in a million.

/// "a bucket not yet seen: 120 in a million further cases (95% interval: 30 to 340); a wrong one:
/// 12 (0 to 74)"; empty where nothing is known of it.
std::string risk_in_words(const CampaignResult& result);

/// A table of the regimes, and of all; empty where nothing is known of them.
std::string risk_rows(const CampaignResult& result);

/// What ended a campaign that the risk was to end, a line and its end; empty for another.
std::string end_by_risk_in_words(const Campaign& campaign);

}  // namespace manifuzz
