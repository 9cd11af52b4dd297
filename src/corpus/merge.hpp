#pragma once

#include <optional>
#include <string>
#include <vector>

#include "corpus/corpus.hpp"

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

}  // namespace manifuzz
