#include "campaign/findings.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace manifuzz {
namespace {

/// The bucket, with the names of those at fault.
std::string key_of(std::string_view bucket, std::string_view subject, std::string_view oracle) {
  const std::string_view fault = bucket.substr(0, bucket.find('/'));
  return fmt::format("{}|{}|{}", bucket,
                     fault == "subject" || fault == "both" ? subject : std::string_view(),
                     fault == "oracle" || fault == "both" ? oracle : std::string_view());
}

}  // namespace

std::string finding_key(const Expectation& expect) {
  return key_of(expect.bucket, expect.subject, expect.oracle);
}

KnownBuckets::KnownBuckets(std::span<const CorpusCase> corpus) {
  for (const CorpusCase& known : corpus) {
    if (!known.expect) continue;
    files_.emplace(finding_key(*known.expect), known.path);
  }
}

std::string KnownBuckets::file_of(const Bucket& bucket, const Collider& subject,
                                  const Collider& oracle) const {
  const auto found =
      files_.find(key_of(to_string(bucket), subject.declaration.name, oracle.declaration.name));
  return found == files_.end() ? std::string() : found->second;
}

std::vector<Finding> findings(const Tally& tally, const Plan& plan, const KnownBuckets& known) {
  std::vector<Finding> found;
  for (std::size_t i = 0; i < kBucketCount; ++i) {
    if (tally.buckets[i].count == 0) continue;
    Finding finding{bucket_at(i), tally.buckets[i], false, {}};
    finding.file = known.file_of(finding.bucket, plan.subject, plan.oracle);
    finding.is_new = finding.file.empty();
    found.push_back(finding);
  }
  return found;
}

bool has_new(std::span<const Finding> found) {
  return std::ranges::any_of(found, &Finding::is_new);
}

}  // namespace manifuzz
