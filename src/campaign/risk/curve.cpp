#include "campaign/risk/curve.hpp"

#include <algorithm>
#include <tuple>

#include "campaign/result.hpp"
#include "campaign/risk/risk.hpp"

namespace manifuzz {
namespace {

/// Where a regime stands in the turn; an unknown one comes last.
std::uint64_t turn_of(const std::string& regime, const CampaignResult& result) {
  const auto found = std::ranges::find(result.regimes, regime, &RegimeResult::name);
  return static_cast<std::uint64_t>(found - result.regimes.begin());
}

/// How many cases of a regime, `count` from index `first` on, come before another case.
std::uint64_t cases_before(std::uint64_t first, std::uint64_t count, bool is_turn_before,
                           std::uint64_t index) {
  if (index < first) return 0;
  const std::uint64_t below = std::min(count, index - first);
  return below + (is_turn_before && below == index - first && below < count ? 1 : 0);
}

/// How many cases of all are run before the bucket's first.
std::uint64_t place_of_first(const BucketResult& found, const CampaignResult& result) {
  const std::tuple place(turn_of(found.regime, result), found.seed);
  std::uint64_t before = 0;
  for (const CasesRun& part : result.parts) {
    for (const auto& [regime, count] : part.cases) {
      const bool is_turn_before = std::tuple(turn_of(regime, result), part.seed) < place;
      before += cases_before(part.first, count, is_turn_before, found.first_index);
    }
  }
  return before;
}

}  // namespace

std::vector<CurvePoint> bucket_curve(const CampaignResult& result) {
  std::vector<CurvePoint> curve;
  for (const BucketResult& found : result.buckets) {
    curve.push_back({place_of_first(found, result) + 1, 1, is_of_fault(found.bucket) ? 1U : 0U});
  }
  std::ranges::sort(curve, {}, &CurvePoint::cases);
  CurvePoint sum;
  for (CurvePoint& point : curve) {
    sum = {point.cases, sum.buckets + point.buckets, sum.wrong + point.wrong};
    point = sum;
  }
  curve.push_back({std::max(sum.cases, result.cases()), sum.buckets, sum.wrong});
  return curve;
}

}  // namespace manifuzz
