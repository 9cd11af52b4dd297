#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "campaign/plan.hpp"
#include "corpus/corpus.hpp"
#include "corpus/shrink.hpp"
#include "process/process.hpp"

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

/// A shrunk case keeps at least this share of the magnitude.
inline constexpr double kMagnitudeShareKept = 0.5;

/// The smallest case like this one: same bucket, same ledger entry, enough of the magnitude. Runs
/// in a child process, so that a collider that dies takes nothing along; stops early when
/// interrupted. Throws Interrupted where it had not begun.
Shrunk shrink_finding(const PairCase& pair, const Collider& subject, const Collider& oracle,
                      Interruption& interruption);

/// Where the corpus keeps such cases: ties, defects/<oracle>, regressions or seeds.
std::filesystem::path corpus_folder(const Bucket& bucket, const std::string& oracle);

/// The corpus case of a pair as these colliders see it: what is right, answers, verdict, severity
/// and a note.
CorpusCase recorded_case(const PairCase& pair, const Judgement& judgement, const Collider& subject,
                         const Collider& oracle, Interruption& interruption);

/// Shrinks the finding's worst witness and writes it to the corpus, and beside it the worst as it
/// was seen; sets `file`. Throws UserError where it cannot be written, and Interrupted.
void save_finding(Finding& finding, const Plan& plan, const std::filesystem::path& corpus,
                  Interruption& interruption);

}  // namespace manifuzz
