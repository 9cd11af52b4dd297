#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "campaign/result_files.hpp"
#include "process/interruption.hpp"

namespace manifuzz {

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
