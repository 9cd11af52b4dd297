#include "cli/fuzz_suite.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/user_error.hpp"
#include "cli/shown.hpp"
#include "report/github.hpp"

namespace manifuzz {
namespace {

TestResult test_of_regime(const Campaign& campaign, std::size_t i) {
  const RegimeTally& regime = campaign.run.tally->regimes[i];
  const double cases = static_cast<double>(campaign.result.cases());
  const double share = cases > 0 ? static_cast<double>(regime.cases) / cases : 0;
  TestResult test{campaign.result.regimes[i].name, share * campaign.result.seconds()};
  if (regime.failures > 0) {
    test.failure =
        TestFailure{fmt::format("{} to be right", campaign.result.settings.subject),
                    fmt::format("{} of {} cases against it", regime.failures, regime.cases)};
  }
  return test;
}

/// The case that a finding is shown by: the shrunk one where it was saved, else the first.
CorpusCase case_of(const Campaign& campaign, const Finding& finding) {
  try {
    if (finding.is_new && !finding.file.empty()) return read_case_file(finding.file);
  } catch (const UserError&) {
    // Somebody took it away: the first shows the same.
  }
  CorpusCase first;
  first.pair = campaign.plan.pair(finding.tally.first);
  return first;
}

TestResult test_of_bucket(const CampaignResult& result, const Finding& finding,
                          const BucketResult& found) {
  TestResult test{found.bucket};
  test.failure = TestFailure{finding.bucket.verdict == Verdict::oracle_wrong
                                 ? fmt::format("nothing new against {}", result.settings.oracle)
                                 : fmt::format("{} to be right", result.settings.subject),
                             fmt::format("{}: {} times, worst {:.2g} of the size", found.bucket,
                                         found.count, found.magnitude),
                             found.file, found.command};
  return test;
}

TestResult failed_test(const std::string& name, const TestFailure& failure) {
  TestResult test{name};
  test.failure = failure;
  return test;
}

std::vector<std::vector<std::string>> verdict_table(const CampaignResult& result) {
  std::vector<std::vector<std::string>> table{{"verdict", "cases"}};
  for (std::size_t i = 0; i < kVerdictNames.size(); ++i) {
    table.push_back({std::string(kVerdictNames[i]), std::to_string(result.verdicts[i])});
  }
  return table;
}

void add_buckets(TestSuite& suite, const Campaign& campaign, Interruption& interruption) {
  const Plan& plan = campaign.plan;
  std::size_t pictures = 0;
  for (std::size_t i = 0; i < campaign.findings.size(); ++i) {
    const Finding& finding = campaign.findings[i];
    if (!decides_status(finding.bucket, finding.is_new)) continue;
    suite.tests.push_back(test_of_bucket(campaign.result, finding, campaign.result.buckets[i]));
    if (++pictures > kDescribedMax) continue;
    add_picture(*suite.tests.back().failure, case_of(campaign, finding), plan.subject, plan.oracle,
                interruption);
  }
}

}  // namespace

TestSuite fuzz_suite(const Campaign& campaign, Interruption& interruption) {
  const CampaignResult& result = campaign.result;
  TestSuite suite{"manifuzz fuzz",
                  fmt::format("{} against {}: {} cases in {:.1f} s, {} unexplained, seed {}{}",
                              result.settings.subject, result.settings.oracle, result.cases(),
                              result.seconds(), result.unexplained(), campaign.plan.seed,
                              result.interrupted ? "; interrupted" : ""),
                  {},
                  verdict_table(result)};
  // What is described first: buckets have cases, regimes only counts.
  add_buckets(suite, campaign, interruption);
  for (const LedgerResult& entry : result.ledger) {
    if (entry.over_budget.empty()) continue;
    suite.tests.push_back(
        failed_test(entry.id, {"no more hits than its budget",
                               fmt::format("more in {}", fmt::join(entry.over_budget, ", "))}));
  }
  if (is_vacuous(result)) {
    suite.tests.push_back(failed_test("vacuous", {"cases that touch", "none"}));
  }
  for (std::size_t i = 0; i < result.regimes.size(); ++i) {
    suite.tests.push_back(test_of_regime(campaign, i));
  }
  return suite;
}

}  // namespace manifuzz
