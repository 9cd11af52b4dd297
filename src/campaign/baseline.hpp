#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "campaign/result.hpp"

namespace manifuzz {

/// How a run's buckets compare with an earlier run's, by their names.
struct BucketComparison {
  std::vector<std::string> appeared;  ///< in this run alone
  std::vector<std::string> gone;      ///< in the earlier one alone
  std::vector<std::string> still;     ///< in both, and no worse
  std::vector<std::string> worse;     ///< in both, its magnitude grown by more than a tenth
};

/// What `fuzz --json` wrote. Throws UserError that names the file.
CampaignResult read_baseline(const std::string& path);

/// One line that names the terms (subject, oracle, seed, first, cases, regimes) in which two runs
/// differ, so that the comparison is not fair; empty where there are none.
std::string differences_in_words(const CampaignResult& earlier, const CampaignResult& now);

BucketComparison compared(const CampaignResult& earlier, const CampaignResult& now);

/// For people: what differs in the terms, and the buckets that are new, worse or gone.
std::string comparison_text(const CampaignResult& earlier, const CampaignResult& now);
nlohmann::ordered_json comparison_json(const BucketComparison& comparison);

}  // namespace manifuzz
