#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "campaign/plan.hpp"
#include "campaign/result.hpp"
#include "process/interruption.hpp"

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

/// What several corpora know of one finding.
struct MergedFinding {
  CorpusCase smallest;              ///< the least complex
  std::optional<CorpusCase> worst;  ///< of the greatest magnitude as it was seen, if another case
};

/// One of each finding (`finding_key`), in the order of the keys; cases that no comparison found
/// (of a property, written by hand) all, but each pair once. Paths of the form name.worst.json are
/// what name.json was shrunk from. Of equally bad witnesses the first in the order of a campaign is
/// kept: by index, then by the regime's place in the list.
std::vector<MergedFinding> merged_findings(const std::vector<CorpusCase>& cases);

/// What several runs left behind, as if one campaign had run all their cases.
struct MergedRuns {
  std::vector<MergedFinding> findings;
  std::optional<CampaignResult> result;  ///< none without any
  std::vector<std::string> errors;       ///< one line for each file that is left out
};

/// Findings are merged as above. Results of `fuzz` are added up in their order: counts are sums, a
/// bucket's first case is the least by index, regime and seed, its magnitude the greatest. Sums may
/// be added up again. A result of other settings than most have, or with cases that are counted
/// already, is left out.
MergedRuns merged_runs(const RunFiles& files);

/// Writes the findings to a folder as a campaign would have, and names their files in the result.
/// Throws UserError, where it is interrupted too.
void write_findings(MergedRuns& runs, const std::filesystem::path& folder,
                    Interruption& interruption);

}  // namespace manifuzz
