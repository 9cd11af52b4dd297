#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "campaign/known.hpp"
#include "corpus/corpus.hpp"
#include "process/interruption.hpp"

namespace manifuzz {

/// Where the corpus keeps such cases: ties, defects/<oracle>, regressions or seeds.
std::filesystem::path corpus_folder(const Bucket& bucket, const std::string& oracle);
std::filesystem::path corpus_folder(const CorpusCase& known);

/// The corpus case of a pair as these colliders see it: what is right, answers, verdict, severity
/// and a note. Once there is hurry, a severity that takes longer than a second is left out, and any
/// after the deadline. Throws Interrupted.
CorpusCase recorded_case(const PairCase& pair, const Judgement& judgement, const Collider& subject,
                         const Collider& oracle, Interruption& interruption,
                         const Deadline& severity_until = {});

/// The finding's case as it was met: where it was found, how often, and by which versions.
Found found_at(const Finding& finding, const Tally& tally, const Plan& plan);

/// How long a campaign shrinks where nobody says.
inline constexpr double kShrinkSeconds = 10;

/// Where a campaign's findings go.
struct SaveTo {
  std::string folder;                      ///< a corpus; empty: nowhere
  Deadline deadline{};                     ///< what is not saved until then is not
  double shrink_seconds = kShrinkSeconds;  ///< of all findings together
};

/// How saving went: one finding that cannot be written does not lose the others.
struct Saving {
  std::string first_error;
  bool interrupted = false;
  std::size_t unsaved = 0;   ///< new findings that were not written, since there was no time
  std::size_t unshrunk = 0;  ///< those that are not as small as can be, for the same reason
};

/// Writes the new findings to the corpus, in their order, and sets their files. Each is shrunk,
/// within its share of the time that is left, and the worst case is written beside it as it was
/// seen; where there is hurry, from the beginning or after a signal, it is written as it was seen
/// alone. `on_finding` is told of each before.
Saving save_new(std::vector<Finding>& found, const Tally& tally, const Plan& plan,
                const SaveTo& save_to, Interruption::State begins,
                const std::function<void(const std::string&)>& on_finding);

}  // namespace manifuzz
