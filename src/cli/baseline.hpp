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

/// An earlier run: its buckets, and what of its terms must be the same for a fair comparison.
struct EarlierRun {
  std::vector<EarlierBucket> buckets;
  nlohmann::ordered_json terms;  ///< oracle, seed, first, cases, regimes; null where not told
};

/// How this run's findings compare with an earlier one's, by their buckets' names.
struct Comparison {
  std::vector<std::string> appeared;  ///< in this run alone
  std::vector<std::string> gone;      ///< in the earlier one alone
  std::vector<std::string> still;     ///< in both, and no worse
  std::vector<std::string> worse;     ///< in both, its magnitude grown by more than a tenth
};

/// What `fuzz --json` wrote. Throws UserError that names the file.
EarlierRun read_baseline(const std::string& path);

/// The terms in what `fuzz --json` writes.
nlohmann::ordered_json terms_in(const nlohmann::ordered_json& report);

/// One line that names the terms in which two runs differ; empty where there are none.
std::string differences_in_words(const nlohmann::ordered_json& earlier,
                                 const nlohmann::ordered_json& now);

Comparison compared(const std::vector<EarlierBucket>& earlier, const std::vector<Finding>& now);

std::string comparison_rows(const Comparison& comparison);
nlohmann::ordered_json comparison_json(const Comparison& comparison);

}  // namespace manifuzz
