#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "campaign/replay.hpp"
#include "campaign/run.hpp"
#include "campaign/smoke.hpp"
#include "corpus/corpus.hpp"
#include "report/outputs.hpp"

namespace manifuzz {

/// Why a test failed, and what helps to look into it; what is not known is empty.
struct TestFailure {
  std::string expected;
  std::string got;
  std::string file{};     ///< of the case, with :line for a line
  std::string command{};  ///< repeats it, for a shell
  std::string picture{};  ///< of characters, in lines
};

struct TestResult {
  std::string name;
  double seconds = 0;
  std::optional<TestFailure> failure{};
  std::string why_skipped{};  ///< of one that neither passed nor failed; else empty
};

/// The results of a run, for JUnit reports and for what CI shows.
struct TestSuite {
  std::string name;  ///< "manifuzz replay"
  std::string headline;
  std::vector<TestResult> tests;
  std::vector<std::vector<std::string>> table{};  ///< rows of equal length, the head first
  std::vector<std::string> errors{};              ///< why parts of the run did not take place

  std::size_t failures() const {
    std::size_t count = 0;
    for (const TestResult& test : tests) count += test.failure ? 1 : 0;
    return count;
  }
  std::size_t skipped() const {
    std::size_t count = 0;
    for (const TestResult& test : tests) count += test.why_skipped.empty() ? 0 : 1;
    return count;
  }
  double seconds() const {
    double sum = 0;
    for (const TestResult& test : tests) sum += test.seconds;
    return sum;
  }
};

/// "expected ..., got ...".
inline std::string in_words(const TestFailure& failure) {
  return "expected " + failure.expected + ", got " + failure.got;
}

/// Text for logs, XML and terminals: bytes that are not UTF-8, as file names may have, become
/// U+FFFD, control characters but those of `kept` blanks.
std::string fit_for_logs(std::string_view text, std::string_view kept = {});

/// A JUnit XML document, valid by the schema of Jenkins: a test case for each test, its class being
/// the suite; the command and the picture are the failure's text.
std::string junit_xml(std::span<const TestSuite> suites);

// Runs as test suites. Of the first failures the cases are drawn, as far as there is time.

/// A test for each regime, failing where anything is wrong with the subject, which takes its share
/// of the time; one for each bucket, each entry of the ledger and the vacuous run that decide the
/// status.
TestSuite fuzz_suite(const Campaign& campaign, Interruption& interruption);

/// A test for each case.
TestSuite replay_suite(const ReplayRun& run, const CalledAgain& again, Interruption& interruption);

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
  /// Annotations then go to the standard error, which is read as well.
  bool stdout_is_data = false;
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

// What GitHub shows of a run: pure text, of plain data.

/// GitHub shows so many annotations of a step, and takes a step summary of so many bytes.
inline constexpr std::size_t kAnnotationsMax = 10;
inline constexpr std::size_t kSummaryBytesMax = 1 << 20;
/// So many failures are described in a summary, with their pictures; the rest is counted.
inline constexpr std::size_t kDescribedMax = 10;

/// "file:12" as file and line; the line is empty where there is none.
std::pair<std::string_view, std::string_view> file_and_line(std::string_view file);

/// What a failure's file is called in the repository, or "" where it lies outside.
using FileInRepository = std::function<std::string(const std::string& file)>;

/// A workflow command, `::error title=...,file=...,line=...::message` and a line's end. A file that
/// ends in :line is annotated at that line; an empty one is left out.
std::string error_annotation(std::string_view title, std::string_view file,
                             std::string_view message);

/// An annotation for each error and each failure, as many as are shown; the last one counts those
/// left out.
std::string annotations(std::span<const TestSuite> suites, const FileInRepository& in_repository);

/// The suites as Markdown of at most `room` bytes: errors and tables, then failures with file,
/// expected, got, picture and command, as many as are described and fit; the rest is counted.
/// `image_of` gives the address of a picture of a failure's file, or "".
std::string step_summary(std::span<const TestSuite> suites, std::size_t room,
                         const std::function<std::string(const std::string& file)>& image_of);

// The step of a GitHub workflow that this process runs in, as its environment describes it.

/// Whether there is one: GITHUB_ACTIONS=true.
bool is_in_workflow();

/// The file of the step's summary, or empty.
std::string step_summary_file();

/// What is wrong with these, with files as the repository has them.
std::string workflow_annotations(std::span<const TestSuite> suites);

/// Appends the suites to the step's summary, what other programs of this step wrote stays. Throws
/// UserError.
void append_step_summary(const std::string& file, std::span<const TestSuite> suites);

}  // namespace manifuzz
