#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/property_check.hpp"
#include "campaign/replay.hpp"
#include "campaign/run.hpp"
#include "campaign/smoke.hpp"
#include "corpus/output_check.hpp"
#include "report/ci/test_suite.hpp"
#include "report/outputs.hpp"

namespace manifuzz {

// Runs as test suites. Of the first failures the cases are drawn, as far as there is time.

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

/// Where a run's test suites go besides a command's own outputs: a JUnit report, and, in a GitHub
/// workflow, annotations and the step summary.
struct CiOutput {
  std::string junit;      ///< a file, "-" for stdout, or empty
  std::string summary{};  ///< the step summary's file, or empty
  bool stdout_is_data =
      false;  ///< annotations then go to the standard error, which is read as well
};

/// `check_outputs` of the command's files and these, and whether stdout is taken. A summary that
/// is another output or an input is left out, with a complaint.
void check_outputs(CommandFiles files, CiOutput& ci);

/// Whether anybody is going to see the suites.
bool is_wanted(const CiOutput& ci);

/// Writes them, last of all outputs: what went wrong with the others is an error of the first
/// suite. A step summary that cannot be written is an error line, and no more.
void write_ci(const CiOutput& ci, std::vector<TestSuite> suites, Outputs& outputs);

/// Runs a command that writes suites of its own where it gets so far. Where it throws, that is what
/// CI is told: a suite of the command's name with this one error; unless it is --junit that is bad.
int run_for_ci(std::string_view command, const CiOutput& ci, const std::function<int()>& run);

}  // namespace manifuzz
