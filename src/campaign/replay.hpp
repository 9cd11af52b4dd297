#pragma once

#include <string>
#include <vector>

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

/// A corpus case that was run again.
struct ReplayedCase {
  const CorpusCase* recorded = nullptr;
  Replayed result;
  double seconds = 0;
};

struct ReplayRun {
  std::string subject;
  std::string oracle;
  std::vector<ReplayedCase> cases;
  double seconds = 0;
  std::size_t left_out = 0;  ///< cases that were not run, since it was time to stop

  std::size_t failed() const;
  std::size_t passed() const { return cases.size() - failed(); }
};

/// Every case again, as far as there is time; the run refers to the cases.
ReplayRun replay_cases(const std::vector<CorpusCase>& cases, const Collider& subject,
                       const Collider& oracle, Interruption& interruption);

}  // namespace manifuzz
