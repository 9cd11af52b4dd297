#include "cli/replay_run.hpp"

#include <chrono>

#include <fmt/format.h>

#include "base/text.hpp"
#include "campaign/in_child.hpp"
#include "cli/collider_options.hpp"
#include "cli/output.hpp"
#include "cli/shown.hpp"
#include "report/github.hpp"
#include "report/style.hpp"

namespace manifuzz {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::string counts_in_words(const ReplayRun& run, const Collider& subject, const Collider& oracle) {
  std::string text = fmt::format("{} against {}: {} cases, {} passed, {} failed, in {:.2f} s",
                                 subject.declaration.name, oracle.declaration.name,
                                 run.tests.size(), run.passed(), run.failures.size(), run.seconds);
  if (run.left_out > 0) text += fmt::format("; {} left out, for time was up", run.left_out);
  return text;
}

/// What the case came to; none where there was no time for it.
std::optional<Replayed> replay_in_time(const CorpusCase& recorded, const Collider& subject,
                                       const Collider& oracle, Interruption& interruption) {
  if (interruption.is_stopped()) return std::nullopt;
  try {
    const Replayed replayed = replay_case(recorded, subject, oracle, interruption);
    return interruption.is_stopped() ? std::nullopt : std::optional(replayed);
  } catch (const Interrupted&) {
    return std::nullopt;
  }
}

}  // namespace

ReplayRun replay_cases(const std::vector<CorpusCase>& cases, const Collider& subject,
                       const Collider& oracle, Interruption& interruption) {
  ReplayRun run;
  const auto start = Clock::now();
  for (const CorpusCase& recorded : cases) {
    const auto case_start = Clock::now();
    const auto replayed = replay_in_time(recorded, subject, oracle, interruption);
    if (!replayed) break;
    TestResult test{recorded.path, seconds_since(case_start)};
    if (!replayed->passed) {
      test.failure = TestFailure{replayed->expected, replayed->got, recorded.path};
      run.failures.push_back({&recorded, *replayed, run.tests.size()});
    }
    run.tests.push_back(test);
  }
  run.left_out = cases.size() - run.tests.size();
  run.seconds = seconds_since(start);
  return run;
}

std::string replay_text(const ReplayRun& run, const Collider& subject, const Collider& oracle) {
  std::string text;
  for (const TestResult& test : run.tests) {
    if (!test.failure) continue;
    text +=
        fmt::format("{} {}: {}\n", bad("FAIL"), printable(test.name, 200), in_words(*test.failure));
  }
  return is_quiet() ? text : text + counts_in_words(run, subject, oracle) + '\n';
}

TestSuite replay_suite(const ReplayRun& run, const Collider& subject, const Collider& oracle,
                       const std::string& options, Interruption& interruption) {
  TestSuite suite{"manifuzz replay", counts_in_words(run, subject, oracle), run.tests};
  suite.table = {{"cases", "passed", "failed", "left out"},
                 {std::to_string(run.tests.size()), std::to_string(run.passed()),
                  std::to_string(run.failures.size()), std::to_string(run.left_out)}};
  std::size_t pictures = 0;
  for (const FailedReplay& failed : run.failures) {
    TestFailure& failure = *suite.tests[failed.test].failure;
    const std::string file(file_and_line(failed.recorded->path).first);
    failure.command =
        fmt::format("{} replay {} {}", this_program(), quoted_for_shell(file), options);
    if (++pictures > kDescribedMax) continue;
    add_picture(failure, *failed.recorded, subject, oracle, interruption);
  }
  return suite;
}

}  // namespace manifuzz
