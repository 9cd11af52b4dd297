#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "campaign/trial.hpp"
#include "corpus/corpus.hpp"
#include "process/interruption.hpp"

namespace manifuzz {

/// The smallest case that is the same finding, as a corpus has it. Throws UserError where there is
/// none, and Interrupted.
CorpusCase shrunk_case(const CorpusCase& given, const Trial& trial, Interruption& interruption);

/// What became of findings that there was no time for when they were saved.
struct ShrunkInPlace {
  std::vector<std::string> files;   ///< of the smallest cases
  std::vector<std::string> errors;  ///< a line for each that could not be shrunk
};

/// Shrinks those of these cases, each in its file's place: the worst seen stays beside the
/// smallest. `on_shrunk` is told of each file. Once it is interrupted, the others are left as they
/// are; throws Interrupted where the one at work is.
ShrunkInPlace shrink_in_place(std::span<const CorpusCase> cases, const TrialOf& trial_of,
                              Interruption& interruption,
                              const std::function<void(const std::string& file)>& on_shrunk);

}  // namespace manifuzz
