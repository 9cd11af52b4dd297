#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "campaign/result_files.hpp"

namespace manifuzz {

/// The results of several campaigns as one result.
struct MergedResult {
  std::optional<CampaignResult> sum;  ///< none without any
  std::vector<std::string> errors;    ///< one line for each result that could not be added
};

/// Adds up results of `fuzz`, in their order, as if one campaign had run all their cases: counts
/// are sums, a bucket's first case is the least by index, regime and seed, its magnitude the
/// greatest. Sums may be added up again. A result of other settings than most have, or with cases
/// that are counted already, is left out.
MergedResult merged_result(std::span<const ResultFile> results);

}  // namespace manifuzz
