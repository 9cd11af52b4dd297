#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "campaign/result.hpp"

namespace manifuzz {

/// The subject's name, or the oracle's, told apart where both have one name.
std::string collider_at_fault(Fault fault, const Settings& settings);

/// Buckets of one kind and of whoever is at fault: what one bug fills several of. Where both are
/// wrong it is the subject's.
struct FindingGroup {
  Fault fault = Fault::subject;
  std::string what;      ///< the kind, or what became of an answer that was lost
  bool is_lost = false;  ///< crashed, timed out or malformed
  std::uint64_t count = 0;
  double magnitude = 0;  ///< the worst of all, as a share of the size
  std::size_t new_buckets = 0;
  /// New ones first; of these the clearest: no near tie, plainly wrong, the most frequent.
  std::vector<const BucketResult*> buckets{};
};

/// Groups the buckets that decide the status, most serious first: the subject's before the
/// oracle's, lost answers before wrong ones, then by magnitude.
std::vector<FindingGroup> finding_groups(const CampaignResult& result);

}  // namespace manifuzz
