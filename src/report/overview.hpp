#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "campaign/result.hpp"

namespace manifuzz {

/// A cause in the ledger, and how often a campaign met it.
struct CauseMet {
  std::uint64_t hits = 0;
  std::string words;
  std::string witness;  ///< the path in the corpus of a case that shows it; empty: not known here
};

/// Buckets of one kind and of whoever is at fault: what one bug fills several of.
struct FindingInWords {
  bool is_new = false;
  std::string what;     ///< "planck: missed contact"
  std::string how;      ///< "12 times in 3 buckets, by 0.2 of the size at worst"
  std::string file;     ///< of the clearest case; empty where it is not saved
  std::string command;  ///< repeats the clearest case
};

/// What a campaign found: what its screen and the first screen of a page say alike.
struct CampaignOverview {
  std::string verdicts;                  ///< "both right and the same 90.2%, ..."
  std::string subject;                   ///< "clip: no wrong answer"
  std::string oracle;                    ///< the same; empty where there is none
  std::vector<CauseMet> causes;          ///< of the oracle's wrong answers, the most frequent first
  std::vector<FindingInWords> findings;  ///< that decide the status, the most serious first
};

CampaignOverview overview_of(const CampaignResult& result);

}  // namespace manifuzz
