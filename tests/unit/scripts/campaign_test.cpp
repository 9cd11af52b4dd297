#include <filesystem>
#include <string>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/run_program.hpp"
#include "support/source_tree.hpp"
#include "support/temporary_folder.hpp"

using namespace manifuzz::test;
using Catch::Contains;
using Json = nlohmann::json;

namespace {

Json quiet_report() {
  return Json::parse(R"({"cases": 5000, "touching": 3000, "buckets": [], "ledger": [],
    "verdicts": {"agree": 5000, "subject_wrong": 0, "oracle_wrong": 0, "both_wrong": 0,
                 "crashed": 0, "timed_out": 0, "malformed": 0}})");
}

Json report_with(const std::string& verdict) {
  Json report = quiet_report();
  report["verdicts"][verdict] = 2;
  report["buckets"].push_back({{"bucket", "some/bucket"},
                               {"verdict", verdict},
                               {"count", 2},
                               {"command", "manifuzz fuzz --seed 7"}});
  return report;
}

/// scripts/campaign over a stand-in for manifuzz that writes `report` and ends with `status`.
Outcome campaign(const std::string& report, int status) {
  const TemporaryFolder folder;
  folder.write("report.json", report);
  const std::string program = folder.write(
      "manifuzz",
      "#!/bin/sh\nwhile [ \"$1\" != --json ]; do shift; done\ncp \"${0%/*}/report.json\" "
      "\"$2\"\necho the table\nexit " +
          std::to_string(status) + "\n");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  return run_program(
      {"env", "MANIFUZZ=" + program, (source_dir() / "scripts/campaign").string(), "1"});
}

}  // namespace

TEST_CASE("a campaign without findings passes") {
  const Outcome outcome = campaign(quiet_report().dump(), 0);
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.out, Contains("the table"));
  CHECK_THAT(outcome.out, Contains("seed "));
}

TEST_CASE("a finding of the oracle alone is reported, not failed") {
  const Outcome outcome = campaign(report_with("oracle_wrong").dump(), 1);
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.out, Contains("some/bucket: 2"));
  CHECK_THAT(outcome.out, Contains("manifuzz fuzz --seed 7"));
}

TEST_CASE("anything wrong with the subject fails the campaign") {
  for (const char* verdict : {"subject_wrong", "both_wrong", "crashed", "timed_out", "malformed"}) {
    CAPTURE(verdict);
    const Outcome outcome = campaign(report_with(verdict).dump(), 1);
    CHECK(outcome.status == 1);
    CHECK_THAT(outcome.out, Contains(std::string(verdict) + ": 2"));
  }
}

TEST_CASE("a ledger entry over its budget fails the campaign") {
  Json report = quiet_report();
  report["ledger"].push_back({{"id", "some-entry"}, {"over_budget", {"grid", "boxes"}}});
  const Outcome outcome = campaign(report.dump(), 1);
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.out, Contains("some-entry"));
  CHECK_THAT(outcome.out, Contains("grid, boxes"));
}

TEST_CASE("a campaign in which nothing touched, or nothing ran, fails") {
  for (const char* key : {"touching", "cases"}) {
    CAPTURE(key);
    Json report = quiet_report();
    report[key] = 0;
    CHECK(campaign(report.dump(), 0).status == 1);
  }
}

TEST_CASE("a report that does not say enough fails the campaign") {
  Json report = quiet_report();
  report["verdicts"].erase("crashed");
  CHECK(campaign(report.dump(), 0).status == 1);
  CHECK(campaign("", 0).status == 1);
  CHECK(campaign("{", 0).status == 1);
  CHECK(campaign("{}", 0).status == 1);
  CHECK(campaign(quiet_report().dump() + quiet_report().dump(), 0).status == 1);
  CHECK(campaign(quiet_report().dump(), 1).status == 1);
}

TEST_CASE("a campaign that could not run fails") {
  CHECK(campaign(quiet_report().dump(), 2).status == 1);
  CHECK(campaign(quiet_report().dump(), 139).status == 1);
}
