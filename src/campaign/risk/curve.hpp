#pragma once

#include <cstdint>
#include <vector>

namespace manifuzz {

struct CampaignResult;

/// So many buckets, and wrong ones among them, were met in the first `cases` cases.
struct CurvePoint {
  std::uint64_t cases = 0;
  std::uint64_t buckets = 0;
  std::uint64_t wrong = 0;  ///< with somebody at fault

  friend bool operator==(const CurvePoint&, const CurvePoint&) = default;
};

/// Buckets against cases: a point at each case that showed one first, and one at the end. All
/// follows from the buckets' first cases, so the jobs change nothing. Cases of several seeds are in
/// the order of one campaign that ran them all: by index, regime and seed, in which the first case
/// of a bucket is that of the merged result.
std::vector<CurvePoint> bucket_curve(const CampaignResult& result);

}  // namespace manifuzz
