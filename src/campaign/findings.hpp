#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "campaign/plan.hpp"
#include "corpus/corpus.hpp"

namespace manifuzz {

/// A bucket that a campaign filled.
struct Finding {
  Bucket bucket;
  BucketTally tally;
  bool is_new = false;  ///< no file of the corpus has its bucket
  std::string file;     ///< of the corpus, where one shows it; else empty
};

/// What a finding is one of: its bucket and who is at fault. Ties count whoever the colliders were.
std::string finding_key(const Expectation& expect);

/// Which buckets a corpus shows already, by their keys.
class KnownBuckets {
 public:
  explicit KnownBuckets(std::span<const CorpusCase> corpus);
  /// The file that shows this bucket, or empty.
  std::string file_of(const Bucket& bucket, const Collider& subject, const Collider& oracle) const;

 private:
  std::map<std::string, std::string> files_;
};

/// Every bucket of the tally but agree, in the order of the bucket's index.
std::vector<Finding> findings(const Tally& tally, const Plan& plan, const KnownBuckets& known);

/// Whether one of them is new.
bool has_new(std::span<const Finding> found);

}  // namespace manifuzz
