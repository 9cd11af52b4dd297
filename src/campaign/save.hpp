#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "campaign/known.hpp"
#include "corpus/corpus.hpp"
#include "process/interruption.hpp"

namespace manifuzz {

/// Where the corpus keeps such cases: pairs in ties, defects/<oracle>, regressions or seeds, others
/// by their kind.
std::filesystem::path corpus_folder(const AnyCase& any, const Bucket& bucket,
                                    const std::string& oracle);
std::filesystem::path corpus_folder(const CorpusCase& known);

/// The finding's case as it was met: where it was found, how often, and by which versions.
Found found_at(const Finding& finding, const Tally& tally, const Plan& plan);

/// How long a campaign shrinks where nobody says.
inline constexpr double kShrinkSeconds = 10;

/// Where a campaign's findings go.
struct SaveTo {
  std::string folder;                      ///< a corpus; empty: nowhere
  Deadline deadline{};                     ///< nobody is asked after it
  double shrink_seconds = kShrinkSeconds;  ///< of all findings together
};

/// How saving went: one finding that cannot be written does not lose the others.
struct Saving {
  std::size_t unwritten = 0;  ///< new findings that could not be written
  std::string first_error;    ///< why the first of them could not
  bool interrupted = false;
  std::size_t unsaved = 0;   ///< new findings that were not written, since somebody asked again
  std::size_t unshrunk = 0;  ///< those that are not as small as can be, for want of time
  std::size_t as_seen = 0;   ///< of these, those about which nobody gave an answer in time
};

/// "3 findings could not be saved: ...", or nothing where all were.
std::string unwritten_in_words(const Saving& saving);

/// Writes the new findings to the corpus, in their order, and sets their files. Each is shrunk,
/// within its share of the time that is left, and the worst case is written beside it as it was
/// seen; where there is hurry, from the beginning or after a signal, it is written as it was seen
/// alone. Who gives no answers in that time is asked no more. `on_finding` is told of each before.
Saving save_new(std::vector<Finding>& found, const Tally& tally, const Plan& plan,
                const SaveTo& save_to, Interruption::State begins,
                const std::function<void(const std::string&)>& on_finding);

}  // namespace manifuzz
