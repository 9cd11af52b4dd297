#include "report/finding_groups.hpp"

#include <algorithm>
#include <string_view>
#include <tuple>

#include <fmt/format.h>

namespace manifuzz {
namespace {

std::string what_is_wrong(const Bucket& bucket) {
  const std::string_view name =
      bucket.kind == Kind::none ? to_string(bucket.verdict) : name_of(bucket.kind, kKindNames);
  std::string words(name);
  std::ranges::replace(words, '_', ' ');
  return words;
}

/// Less comes first.
auto place_in_group(const BucketResult* found) {
  const auto bucket = find_bucket(found->bucket);
  const bool is_near_tie = !bucket || bucket->tie_class != TieClass::none;
  const bool is_plain = bucket && bucket->error_class == ErrorClass::gross;
  return std::tuple(!found->is_new, is_near_tie, !is_plain, ~found->count);
}

auto place_of_group(const FindingGroup& group) {
  return std::tuple(group.fault == Fault::oracle, !group.is_lost, -group.magnitude, ~group.count);
}

FindingGroup& group_of(std::vector<FindingGroup>& groups, const Bucket& bucket) {
  const Fault fault = bucket.fault == Fault::oracle ? Fault::oracle : Fault::subject;
  const std::string what = what_is_wrong(bucket);
  const auto same = std::ranges::find_if(groups, [&](const FindingGroup& group) {
    return group.fault == fault && group.what == what;
  });
  if (same != groups.end()) return *same;
  return groups.emplace_back(
      FindingGroup{.fault = fault, .what = what, .is_lost = is_of_lost(bucket)});
}

}  // namespace

std::string collider_at_fault(Fault fault, const Settings& settings) {
  const bool is_oracle = fault == Fault::oracle;
  const std::string& name = is_oracle ? settings.oracle : settings.subject;
  if (settings.subject != settings.oracle) return name;
  return fmt::format("{} ({})", name, is_oracle ? "oracle" : "subject");
}

std::vector<FindingGroup> finding_groups(const CampaignResult& result) {
  std::vector<FindingGroup> groups;
  for (const BucketResult& found : result.buckets) {
    if (!decides_status(found)) continue;
    const Bucket bucket = find_bucket(found.bucket).value_or(Bucket{.fault = Fault::subject});
    FindingGroup& group = group_of(groups, bucket);
    group.count += found.count;
    group.magnitude = std::max(group.magnitude, found.error.magnitude);
    group.new_buckets += found.is_new ? 1 : 0;
    group.buckets.push_back(&found);
  }
  for (FindingGroup& group : groups) {
    std::ranges::stable_sort(group.buckets, {}, place_in_group);
  }
  std::ranges::stable_sort(groups, {}, place_of_group);
  return groups;
}

}  // namespace manifuzz
