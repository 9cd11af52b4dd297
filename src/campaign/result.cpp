#include "campaign/result.hpp"

#include <algorithm>

namespace manifuzz {
namespace {

std::uint64_t sum_of(const std::vector<RegimeResult>& regimes, std::uint64_t RegimeResult::*count) {
  std::uint64_t sum = 0;
  for (const RegimeResult& regime : regimes) sum += regime.*count;
  return sum;
}

}  // namespace

std::uint64_t CampaignResult::cases() const {
  return sum_of(regimes, &RegimeResult::cases);
}

std::uint64_t CampaignResult::touching() const {
  return sum_of(regimes, &RegimeResult::touching);
}

std::uint64_t CampaignResult::near() const {
  return sum_of(regimes, &RegimeResult::near);
}

std::uint64_t CampaignResult::unexplained() const {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    if (is_unexplained(static_cast<Verdict>(i))) sum += verdicts[i];
  }
  return sum;
}

double CampaignResult::seconds() const {
  double sum = 0;
  for (const CasesRun& part : parts) sum += part.seconds;
  return sum;
}

std::optional<std::uint64_t> CampaignResult::seed() const {
  if (parts.empty() || parts.front().seed != parts.back().seed) return std::nullopt;
  return parts.front().seed;
}

std::uint64_t CampaignResult::first() const {
  const auto least = std::ranges::min_element(parts, {}, &CasesRun::first);
  return least == parts.end() ? 0 : least->first;
}

bool overlap(const CasesRun& part, const CasesRun& with) {
  if (part.seed != with.seed) return false;
  return std::ranges::any_of(part.cases, [&](const auto& regime) {
    const auto& [name, cases] = regime;
    const auto same = with.cases.find(name);
    if (same == with.cases.end()) return false;
    return part.first < with.first ? with.first - part.first < cases
                                   : part.first - with.first < same->second;
  });
}

bool is_vacuous(const CampaignResult& result) {
  if (result.cases() == 0) return true;
  std::uint64_t cases = 0;
  std::uint64_t touching = 0;
  for (const RegimeResult& regime : result.regimes) {
    if (regime.name == "separated") continue;
    cases += regime.cases;
    touching += regime.touching;
  }
  return cases >= kVacuousCases && touching == 0;
}

bool decides_status(const Bucket& bucket, bool is_new) {
  return is_failure(bucket) || (is_new && bucket.verdict == Verdict::oracle_wrong);
}

bool decides_status(const BucketResult& found) {
  const auto bucket = find_bucket(found.bucket);
  return !bucket || decides_status(*bucket, found.is_new);
}

bool has_failed(const CampaignResult& result) {
  return is_vacuous(result) ||
         std::ranges::any_of(result.buckets,
                             [](const BucketResult& found) { return decides_status(found); }) ||
         std::ranges::any_of(result.ledger,
                             [](const LedgerResult& entry) { return !entry.over_budget.empty(); });
}

}  // namespace manifuzz
