#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "campaign/plan.hpp"
#include "corpus/corpus.hpp"
#include "process/interruption.hpp"

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

/// Which buckets a corpus shows already: a file for each, by their keys.
using KnownBuckets = std::map<std::string, std::string>;
KnownBuckets known_buckets(std::span<const CorpusCase> corpus);

/// Every bucket of the tally but agree, in the order of the bucket's index.
std::vector<Finding> findings(const Tally& tally, const Plan& plan, const KnownBuckets& known);

/// Whether one of them is new.
bool has_new(std::span<const Finding> found);

/// Where the corpus keeps such cases: ties, defects/<oracle>, regressions or seeds.
std::filesystem::path corpus_folder(const Bucket& bucket, const std::string& oracle);

/// The corpus case of a pair as these colliders see it: what is right, answers, verdict, severity
/// and a note. Once there is hurry, a severity that takes longer than a second is left out. Throws
/// Interrupted.
CorpusCase recorded_case(const PairCase& pair, const Judgement& judgement, const Collider& subject,
                         const Collider& oracle, Interruption& interruption);

/// Where a campaign's findings go.
struct SaveTo {
  std::string folder;   ///< a corpus; empty: nowhere
  Deadline deadline{};  ///< what is not saved until then is not
};

/// How saving went: one finding that cannot be written does not lose the others.
struct Saving {
  std::string first_error;
  bool interrupted = false;
  std::size_t unsaved = 0;  ///< new findings that were not written, since there was no time
};

/// Writes the new findings to the corpus, what decides the status first, and sets their files. Each
/// is shrunk, and the worst case is written beside it as it was seen; where there is hurry, from
/// the beginning or after a signal, it is written as it was seen alone. `on_finding` is told of
/// each before.
Saving save_new(std::vector<Finding>& found, const Plan& plan, const SaveTo& save_to,
                Interruption::State begins,
                const std::function<void(const std::string&)>& on_finding);

}  // namespace manifuzz
