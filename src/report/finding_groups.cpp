#include "report/finding_groups.hpp"

#include <algorithm>
#include <string_view>
#include <tuple>

#include <fmt/format.h>

namespace manifuzz {
namespace {

std::string collider_at_fault(Fault fault, const Settings& settings) {
  if (fault == Fault::both) return fmt::format("{} and {}", settings.subject, settings.oracle);
  return fault == Fault::oracle ? settings.oracle : settings.subject;
}

std::string what_is_wrong(const Bucket& bucket) {
  const std::string_view name =
      bucket.kind == Kind::none ? to_string(bucket.verdict) : name_of(bucket.kind, kKindNames);
  std::string words(name);
  std::ranges::replace(words, '_', ' ');
  return words;
}

/// Less is clearer: nothing else lies within bound, then the greatest error, then the most
/// frequent.
auto place_by_clarity(const BucketResult& found) {
  const auto bucket = find_bucket(found.bucket);
  const bool is_near_tie = !bucket || bucket->tie_class != TieClass::none;
  return std::tuple(is_near_tie, -found.error.magnitude, ~found.count);
}

auto place_of_group(const FindingGroup& group, const Settings& settings) {
  return std::tuple(group.at_fault == settings.oracle, -group.magnitude, ~group.count);
}

}  // namespace

std::vector<FindingGroup> finding_groups(const CampaignResult& result) {
  std::vector<FindingGroup> groups;
  for (const BucketResult& found : result.buckets) {
    if (!decides_status(found)) continue;
    const Bucket bucket = find_bucket(found.bucket).value_or(Bucket{.fault = Fault::subject});
    FindingGroup one{collider_at_fault(bucket.fault, result.settings), what_is_wrong(bucket)};
    const auto same = std::ranges::find_if(groups, [&](const FindingGroup& group) {
      return group.at_fault == one.at_fault && group.what == one.what;
    });
    FindingGroup& group = same == groups.end() ? groups.emplace_back(std::move(one)) : *same;
    group.count += found.count;
    group.magnitude = std::max(group.magnitude, found.error.magnitude);
    group.is_new = group.is_new || found.is_new;
    group.buckets.push_back(&found);
  }
  for (FindingGroup& group : groups) {
    std::ranges::stable_sort(group.buckets, {},
                             [](const BucketResult* found) { return place_by_clarity(*found); });
  }
  std::ranges::stable_sort(groups, {}, [&](const FindingGroup& group) {
    return place_of_group(group, result.settings);
  });
  return groups;
}

}  // namespace manifuzz
