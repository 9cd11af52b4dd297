#pragma once

#include <span>
#include <string>
#include <vector>

#include "campaign/property_check.hpp"
#include "campaign/replay.hpp"
#include "campaign/run.hpp"
#include "campaign/smoke.hpp"
#include "report/ci/test_suite.hpp"

// Runs as test suites. Of the first failures the cases are drawn, as far as there is time.

namespace manifuzz {

/// How a run is called again, for a shell: this program, and the options that choose colliders,
/// seed and corpus.
struct CalledAgain {
  std::string program;
  std::string options;
};

/// A test for each regime, failing where anything is wrong with the subject, which takes its share
/// of the time; one for each bucket, each entry of the ledger and the vacuous run that decide the
/// status.
TestSuite fuzz_suite(const Campaign& campaign, Interruption& interruption);

/// A test for each case.
TestSuite replay_suite(const ReplayRun& run, const Collider& subject, const Collider& oracle,
                       const CalledAgain& again, Interruption& interruption);

/// A test for each property for which there was time.
TestSuite property_suite(std::span<const CheckedProperty> checked, const Collider& subject,
                         const CalledAgain& again, Interruption& interruption);

/// A suite for each part that there was time for; `again` calls both colliders, `subject_again` the
/// subject alone.
std::vector<TestSuite> smoke_suites(const SmokeRun& run, const SmokePlan& plan,
                                    const CalledAgain& again, const CalledAgain& subject_again);

}  // namespace manifuzz
