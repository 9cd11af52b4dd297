#include "report/ci/ci_output.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text.hpp"
#include "campaign/in_child.hpp"
#include "campaign/plan.hpp"
#include "report/picture/pictures.hpp"

namespace manifuzz {
namespace {

/// Draws what `draw` gives; what there is no time for is left out.
template <class Draw>
void add_picture(TestFailure& failure, const Draw& draw) {
  try {
    failure.picture = draw();
  } catch (const Interrupted&) {
  }
}

TestResult test_of_regime(const Campaign& campaign, std::size_t i) {
  const RegimeResult& regime = campaign.result.regimes[i];
  const std::uint64_t failures = failures_in(campaign.result, regime.name);
  const double cases = static_cast<double>(campaign.result.cases());
  const double share = cases > 0 ? static_cast<double>(regime.cases) / cases : 0;
  TestResult test{regime.name, share * campaign.result.seconds()};
  if (failures > 0) {
    test.failure =
        TestFailure{fmt::format("{} to be right", campaign.result.settings.subject),
                    fmt::format("{} of {} against it", failures, counted(regime.cases, "case"))};
  }
  return test;
}

/// The case that stands for a finding: the shrunk one where it was saved, else the first.
CorpusCase case_of(const Campaign& campaign, const Finding& finding) {
  try {
    if (finding.is_new && !finding.file.empty()) {
      return read_case_file(finding.file, campaign.plan.work->kind());
    }
  } catch (const UserError&) {
    // Somebody took it away: the first shows the same.
  }
  return {campaign.plan.work->draw(campaign.plan, finding.tally.first)};
}

TestResult failed_test(const std::string& name, const TestFailure& failure) {
  TestResult test{name};
  test.failure = failure;
  return test;
}

TestResult test_of_bucket(const CampaignResult& result, const Finding& finding,
                          const BucketResult& found) {
  const std::string expected = finding.bucket.verdict == Verdict::oracle_wrong
                                   ? fmt::format("nothing new against {}", result.settings.oracle)
                                   : fmt::format("{} to be right", result.settings.subject);
  return failed_test(found.bucket,
                     {expected,
                      fmt::format("{}: {}, worst {:.2g} of the size{}{}", found.bucket,
                                  times_in_words(found.count), found.error.magnitude,
                                  found.objection.empty() ? "" : "; ", found.objection),
                      found.file, found.command});
}

void add_buckets(TestSuite& suite, const Campaign& campaign, Interruption& interruption) {
  const Plan& plan = campaign.plan;
  std::size_t pictures = 0;
  for (std::size_t i = 0; i < campaign.findings.size(); ++i) {
    const Finding& finding = campaign.findings[i];
    if (!decides_status(campaign.result.buckets[i])) continue;
    suite.tests.push_back(test_of_bucket(campaign.result, finding, campaign.result.buckets[i]));
    if (!has_text_picture(plan.work->kind()) || ++pictures > kDescribedMax) continue;
    add_picture(*suite.tests.back().failure, [&] {
      return text_picture(
          judged_case(case_of(campaign, finding), plan.subject, plan.oracle, interruption));
    });
  }
}

TestFailure failure_of(const CheckedProperty& checked, const CalledAgain& again) {
  const PropertyResult& result = checked.result;
  TestFailure failure{std::string(checked.property->sentence),
                      result.why.empty() ? "a failure" : result.why, checked.saved};
  if (!result.failing) return failure;
  failure.got += " of ";
  append_case_line(failure.got, *result.failing);
  if (!result.reproduce.empty()) {
    failure.command = fmt::format("RC_PARAMS={} ", quoted_for_shell(result.reproduce));
  }
  failure.command +=
      fmt::format("{} property {} {}", again.program, checked.names_again(), again.options);
  return failure;
}

TestFailure failure_of(const ReplayedCase& replayed, const CalledAgain& again) {
  const std::string& path = replayed.recorded->path;
  const std::string file(file_and_line(path).first);
  return {replayed.result.expected, replayed.result.got, path,
          fmt::format("{} replay {} {}", again.program, quoted_for_shell(file), again.options)};
}

}  // namespace

TestSuite fuzz_suite(const Campaign& campaign, Interruption& interruption) {
  const CampaignResult& result = campaign.result;
  TestSuite suite{
      "manifuzz fuzz",
      fmt::format("{} against {}: {} in {:.1f} s, {} unexplained, {} accepted, seed {}{}",
                  result.settings.subject, result.settings.oracle, counted(result.cases(), "case"),
                  result.seconds(), result.unexplained(), result.accepted(), campaign.plan.seed,
                  result.interrupted ? "; interrupted" : ""),
      {},
      {{"verdict", "cases"}}};
  for (std::size_t i = 0; i < kVerdictNames.size(); ++i) {
    suite.table.push_back({std::string(kVerdictNames[i]), std::to_string(result.verdicts[i])});
  }
  // What is described first: buckets have cases, regimes only counts.
  add_buckets(suite, campaign, interruption);
  for (const LedgerResult& entry : result.ledger) {
    if (entry.over_budget.empty()) continue;
    suite.tests.push_back(
        failed_test(entry.id, {"no more hits than its budget",
                               fmt::format("more in {}", fmt::join(entry.over_budget, ", "))}));
  }
  if (is_vacuous(result)) {
    const char* const missing =
        is_all_unsupported(result) ? "cases that both can take" : "cases that touch";
    suite.tests.push_back(failed_test("vacuous", {missing, "none"}));
  }
  for (std::size_t i = 0; i < result.regimes.size(); ++i) {
    suite.tests.push_back(test_of_regime(campaign, i));
  }
  return suite;
}

TestSuite replay_suite(const ReplayRun& run, const CalledAgain& again, Interruption& interruption) {
  TestSuite suite{"manifuzz replay", replay_counts(run), {}};
  suite.table = {{"cases", "passed", "failed", "unsupported", "accepted", "left out"},
                 {std::to_string(run.cases.size()), std::to_string(run.passed()),
                  std::to_string(run.failed()), std::to_string(run.unsupported()),
                  std::to_string(run.accepted()), std::to_string(run.left_out)}};
  for (const CorpusCase* const one : run.unasked) suite.errors.push_back(why_unasked(*one));
  std::size_t pictures = 0;
  for (const ReplayedCase& one : run.cases) {
    TestResult& test = suite.tests.emplace_back(TestResult{one.recorded->path, one.seconds});
    const Collider& subject = one.trial->subject();
    const Collider& oracle = one.trial->oracle();
    if (one.result.is_unsupported) {
      const std::string& other = oracle.declaration.name;
      test.why_skipped = fmt::format("unsupported: {}{}{} cannot take it", subject.declaration.name,
                                     other.empty() ? "" : " or ", other);
    }
    if (!one.result.has_failed()) continue;
    test.failure = failure_of(one, again);
    if (!has_text_picture(kind_of(one.recorded->any)) || ++pictures > kDescribedMax) continue;
    add_picture(*test.failure, [&] {
      return text_picture(judged_case(*one.recorded, subject, oracle, interruption));
    });
  }
  return suite;
}

TestSuite property_suite(std::span<const CheckedProperty> checked, const Collider& subject,
                         const CalledAgain& again, Interruption& interruption) {
  TestSuite suite{"manifuzz property", "", {}, {{"property", "result", "cases", "seconds"}}};
  std::size_t pictures = 0;
  std::size_t left_out = 0;
  for (const CheckedProperty& one : checked) {
    if (one.is_left_out()) {
      ++left_out;
      continue;
    }
    TestResult test{std::string(one.property->name), one.seconds};
    if (!one.holds()) test.failure = failure_of(one, again);
    if (test.failure && one.result.failing && ++pictures <= kDescribedMax) {
      add_picture(*test.failure, [&] {
        const auto answer = declared_answer(subject, *one.result.failing, interruption);
        return text_picture(*one.result.failing, {&answer, 1});
      });
    }
    suite.table.push_back({test.name,
                           one.is_vacuous()    ? "applies to none"
                           : one.result.passed ? "ok"
                           : one.is_accepted   ? "accepted"
                                               : "FAIL",
                           std::to_string(one.result.cases), fmt::format("{:.2f}", one.seconds)});
    suite.tests.push_back(test);
  }
  suite.headline =
      fmt::format("{}: {}, {} failed", subject.declaration.name,
                  counted(suite.tests.size(), "property", "properties"), suite.failures());
  if (left_out > 0) suite.headline += fmt::format("; {} left out, for time was up", left_out);
  return suite;
}

std::vector<TestSuite> smoke_suites(const SmokeRun& run, const SmokePlan& plan,
                                    const CalledAgain& again, const CalledAgain& subject_again) {
  Interruption in_time({.first_signal = Interruption::State::stopped, .stopped_at = plan.end()});
  std::vector<TestSuite> suites{replay_suite(run.replayed, again, in_time),
                                property_suite(run.checked, plan.subject, subject_again, in_time)};
  if (run.campaign) suites.push_back(fuzz_suite(*run.campaign, in_time));
  suites.front().errors = plan.known_cases.errors;
  return suites;
}

void check_outputs(CommandFiles files, CiOutput& ci) {
  files.outputs.push_back({"--junit", ci.junit});
  const std::string summary = step_summary_file();
  if (is_apart({"GITHUB_STEP_SUMMARY", summary}, files)) {
    ci.summary = summary;
  } else {
    write_complaint("GITHUB_STEP_SUMMARY: is another output or an input; the summary is left out");
  }
  ci.stdout_is_data = check_outputs(files);
}

bool is_wanted(const CiOutput& ci) {
  return !ci.junit.empty() || is_in_workflow();
}

void write_ci(const CiOutput& ci, std::vector<TestSuite> suites, Outputs& outputs) {
  auto& errors = suites.front().errors;
  errors.insert(errors.end(), outputs.errors().begin(), outputs.errors().end());
  outputs.write(!ci.junit.empty(), [&] { write_data(ci.junit, junit_xml(suites)); });
  if (!is_in_workflow()) return;
  const std::string text = workflow_annotations(suites);
  ci.stdout_is_data ? write_error(text) : write_to_reader(text);
  Outputs of_workflow;  // whose errors decide no status
  of_workflow.write(!ci.summary.empty(), [&] { append_step_summary(ci.summary, suites); });
}

int run_for_ci(std::string_view command, const CiOutput& ci, const std::function<int()>& run) {
  try {
    return run();
  } catch (const std::exception& error) {
    const auto* const bad = dynamic_cast<const BadOutput*>(&error);
    if (bad != nullptr && bad->concerns("--junit")) throw;
    TestSuite suite{fmt::format("manifuzz {}", command), "", {}};
    suite.errors.emplace_back(error.what());
    Outputs outputs;
    write_ci(ci, {suite}, outputs);
    throw;
  }
}

}  // namespace manifuzz
