#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "campaign/findings.hpp"
#include "process/interruption.hpp"

namespace manifuzz {

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
