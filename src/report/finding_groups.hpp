#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "campaign/result.hpp"

namespace manifuzz {

/// Buckets of one kind and of whoever is at fault: what one bug fills several of.
struct FindingGroup {
  std::string at_fault;  ///< the collider, or both
  std::string what;      ///< the kind, or what became of an answer that was lost
  std::uint64_t count = 0;
  double magnitude = 0;                        ///< the worst of all, as a share of the size
  bool is_new = false;                         ///< one of the buckets is
  std::vector<const BucketResult*> buckets{};  ///< the clearest first: no near tie, the most wrong
};

/// Of the buckets that decide the status, the most serious groups first: the subject's before the
/// oracle's, then by magnitude.
std::vector<FindingGroup> finding_groups(const CampaignResult& result);

}  // namespace manifuzz
