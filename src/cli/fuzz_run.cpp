#include "cli/fuzz_run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign/guarded.hpp"
#include "campaign/rounds.hpp"
#include "cases/user_error.hpp"
#include "cli/shown.hpp"
#include "report/github.hpp"

namespace manifuzz {
namespace {

/// A second signal ends the saving. The first one ended the shrinking: what it cut short is begun
/// again without.
void save_unless_hurried(Finding& finding, const Plan& plan, const std::string& corpus,
                         Interruption& interruption) {
  try {
    save_finding(finding, plan, corpus, interruption);
  } catch (const Interrupted&) {
    if (interruption.requests() > 1) throw;
    interruption.forgive();
    save_finding(finding, plan, corpus, interruption);
  }
}

TestResult test_of_regime(const CampaignReport& report, std::size_t i) {
  const Tally& tally = *report.run.tally;
  const RegimeTally& regime = tally.regimes[i];
  const double share = tally.cases() == 0
                           ? 0
                           : static_cast<double>(regime.cases) / static_cast<double>(tally.cases());
  TestResult test{std::string(report.plan.regimes[i]->name), share * report.run.seconds};
  if (regime.failures > 0) {
    test.failure =
        TestFailure{fmt::format("{} to be right", report.plan.subject.declaration.name),
                    fmt::format("{} of {} cases against it", regime.failures, regime.cases)};
  }
  return test;
}

/// The case that a finding is shown by: the shrunk one where it was saved, else the first.
CorpusCase case_of(const CampaignReport& report, const Finding& finding) {
  if (finding.is_new && !finding.file.empty()) return read_case_file(finding.file);
  CorpusCase first;
  first.pair = report.plan.pair(finding.tally.first);
  return first;
}

TestResult test_of_finding(const CampaignReport& report, const Finding& finding) {
  const Collider& subject = report.plan.subject;
  TestResult test{to_string(finding.bucket)};
  test.failure =
      TestFailure{finding.bucket.verdict == Verdict::oracle_wrong
                      ? fmt::format("nothing new against {}", report.plan.oracle.declaration.name)
                      : fmt::format("{} to be right", subject.declaration.name),
                  fmt::format("{}: {} times, worst {:.2g} of the size", to_string(finding.bucket),
                              finding.tally.count, finding.tally.magnitude),
                  finding.file, command_of(report, finding)};
  return test;
}

std::vector<std::vector<std::string>> verdict_table(const Tally& tally) {
  std::vector<std::vector<std::string>> table{{"verdict", "cases"}};
  for (std::size_t i = 0; i < kVerdictNames.size(); ++i) {
    table.push_back({std::string(kVerdictNames[i]), std::to_string(tally.verdicts[i])});
  }
  return table;
}

}  // namespace

void narrow_to_colliders(Plan& plan) {
  plan.is_narrowed =
      !plan.subject.declaration.takes_radius || !plan.oracle.declaration.takes_radius;
  if (plan.is_narrowed) plan.context.radius = 0.0F;
}

JobsResult run_watched(const Plan& plan, const KnownBuckets& known) {
  Interruption interruption;
  ProgressLine line;
  return run_plan(plan, known, interruption,
                  [&](const Progress& progress) { line.show(progress_line(plan, progress)); });
}

Saving save_new(std::vector<Finding>& found, const Plan& plan, const std::string& corpus,
                Interruption& interruption) {
  ProgressLine line;
  Saving saving;
  for (Finding& finding : found) {
    if (!finding.is_new) continue;
    if (interruption.requests() > 1) {
      ++saving.unsaved;
      continue;
    }
    line.show("shrinking " + to_string(finding.bucket));
    try {
      save_unless_hurried(finding, plan, corpus, interruption);
    } catch (const Interrupted&) {
      ++saving.unsaved;
    } catch (const UserError& error) {
      if (saving.first_error.empty()) saving.first_error = error.what();
    }
  }
  saving.interrupted = interruption.requests() > 0;
  return saving;
}

TestSuite fuzz_suite(const CampaignReport& report, bool with_pictures, Interruption& interruption) {
  const Plan& plan = report.plan;
  const Tally& tally = *report.run.tally;
  TestSuite suite{"manifuzz fuzz",
                  fmt::format("{} against {}: {} cases in {:.1f} s, {} unexplained, seed {}",
                              plan.subject.declaration.name, plan.oracle.declaration.name,
                              tally.cases(), report.run.seconds, tally.unexplained(), plan.seed),
                  {},
                  verdict_table(tally)};
  // What is described first: buckets have cases, regimes only counts.
  std::size_t pictures = 0;
  for (const Finding& finding : report.findings) {
    if (!decides_status(finding)) continue;
    suite.tests.push_back(test_of_finding(report, finding));
    if (!with_pictures || ++pictures > kDescribedMax) continue;
    add_picture(*suite.tests.back().failure, case_of(report, finding), plan.subject, plan.oracle,
                interruption);
  }
  for (const LedgerCount& count : report.ledger) {
    if (count.over_budget.empty()) continue;
    suite.tests.push_back({std::string(count.entry->id)});
    suite.tests.back().failure =
        TestFailure{"no more hits than its budget",
                    fmt::format("more in {}", fmt::join(count.over_budget, ", "))};
  }
  if (is_vacuous(report)) {
    suite.tests.push_back({"vacuous"});
    suite.tests.back().failure = TestFailure{"cases that touch", "none"};
  }
  for (std::size_t i = 0; i < plan.regimes.size(); ++i) {
    suite.tests.push_back(test_of_regime(report, i));
  }
  return suite;
}

}  // namespace manifuzz
