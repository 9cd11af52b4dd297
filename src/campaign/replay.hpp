#pragma once

#include <string>

#include "corpus/corpus.hpp"
#include "judging/judge.hpp"
#include "process/interruption.hpp"

namespace manifuzz {

struct Replayed {
  bool passed = false;
  std::string expected;  ///< for people, where it failed
  std::string got;
};

/// Runs a corpus case again. It passes when the subject is right. Where the recorded pair of
/// colliders runs, the recorded verdict and bucket must come out too, unless they were against the
/// subject: that it is right now is what a regression waits for. A case that a property failed on
/// must pass that property.
Replayed replay_case(const CorpusCase& recorded, const Collider& subject, const Collider& oracle,
                     Interruption& interruption);

}  // namespace manifuzz
