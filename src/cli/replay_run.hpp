#pragma once

#include <string>
#include <vector>

#include "campaign/replay.hpp"
#include "cli/ci_output.hpp"

namespace manifuzz {

struct FailedReplay {
  const CorpusCase* recorded = nullptr;
  Replayed replayed;
  std::size_t test = 0;  ///< its place among the tests
};

struct ReplayRun {
  double seconds = 0;
  std::vector<FailedReplay> failures;
  std::vector<TestResult> tests;  ///< one a case that was replayed
  std::size_t left_out = 0;       ///< cases that were not, since it was time to stop

  std::size_t passed() const { return tests.size() - failures.size(); }
};

/// Every case again, as far as there is time; the run refers to the cases.
ReplayRun replay_cases(const std::vector<CorpusCase>& cases, const Collider& subject,
                       const Collider& oracle, Interruption& interruption);

/// For people: what failed, and a line that counts.
std::string replay_text(const ReplayRun& run, const Collider& subject, const Collider& oracle);

/// The run as a suite, of which `options` choose the parties again; the first failures with
/// pictures, as far as there is time.
TestSuite replay_suite(const ReplayRun& run, const Collider& subject, const Collider& oracle,
                       const std::string& options, Interruption& interruption);

}  // namespace manifuzz
