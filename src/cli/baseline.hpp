#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "campaign/findings.hpp"

namespace manifuzz {

/// A bucket of an earlier run, as its JSON has it.
struct EarlierBucket {
  std::string bucket;
  double magnitude = 0;
};

/// How this run's findings compare with an earlier one's, by their buckets' names.
struct Comparison {
  std::vector<std::string> appeared;  ///< in this run alone
  std::vector<std::string> gone;      ///< in the earlier one alone
  std::vector<std::string> still;     ///< in both, and no worse
  std::vector<std::string> worse;     ///< in both, its magnitude grown by more than a tenth
};

/// The buckets in what `fuzz --json` wrote. Throws UserError that names the file.
std::vector<EarlierBucket> read_baseline(const std::string& path);

Comparison compared(const std::vector<EarlierBucket>& earlier, const std::vector<Finding>& now);

std::string comparison_rows(const Comparison& comparison);
nlohmann::ordered_json comparison_json(const Comparison& comparison);

}  // namespace manifuzz
