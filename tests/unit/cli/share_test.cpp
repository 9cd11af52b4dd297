#include <filesystem>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "support/interruption.hpp"
#include "unit/cli/merge_runs.hpp"

using namespace manifuzz::test;
using Catch::Contains;

namespace {

using Words = std::vector<std::string>;

const Words kPairs{"--regime=sliver", "--regime=tie_bias", "--regime=separated", "--radius=0",
                   "--ties",          "--judge-every=5",   "--seed=2",           "--first=11",
                   "--cases=4001"};
const Words kSequences{"--subject=cached-bullet", "--seed=1", "--cases=45"};

/// A campaign to NAME.json in the folder, with its findings in NAME/.
Json fuzz(const TemporaryFolder& folder, const std::string& name, const Words& cases,
          const Words& more = {}) {
  const std::string found = (folder.path() / name).string();
  const Words words = with(with({"fuzz", "--shrink-seconds=60", "--corpus=nothing"}, cases), more);
  CHECK(run_manifuzz(with(words, {"--found=" + found, "--json=" + found + ".json"})).status <= 1);
  return Json::parse(text_of(found + ".json"));
}

/// All but what clocks, and shrinking from more than one case, may make otherwise.
Json counted(Json run) {
  for (const char* key : {"seconds", "cases_per_second", "unshrunk", "hints"}) run.erase(key);
  for (Json& bucket : run["buckets"]) bucket.erase("file");
  return run;
}

/// All shares of so many, merged.
Json merged(const TemporaryFolder& folder, const Words& cases, int shares) {
  Words names;
  const std::string all = "of" + std::to_string(shares);
  for (int share = shares - 1; share >= 0; --share) {
    const std::string name = all + "-" + std::to_string(share);
    const std::string which = std::to_string(share) + "/" + std::to_string(shares);
    fuzz(folder, name, cases, {"--share=" + which, share % 2 == 0 ? "--jobs=1" : "--jobs=2"});
    names.insert(names.begin(), name);  // without findings there is no folder
    if (!std::filesystem::exists(folder.path() / name)) names.erase(names.begin());
    names.push_back(name + ".json");
  }
  const Outcome outcome = merge(folder, names, all);
  INFO(outcome.err);
  CHECK(outcome.status == 0);
  return Json::parse(text_of(folder.path() / (all + ".json")));
}

}  // namespace

TEST_CASE("all shares of a campaign, merged, are the campaign, bit for bit, however many",
          "[longer]") {
  const TemporaryFolder folder;
  const Json whole = fuzz(folder, "whole", kPairs, {"--jobs=2"});
  REQUIRE(whole["buckets"].size() >= 3);
  REQUIRE(whole["agreeing_judged"].get<int>() > 100);
  for (const int shares : {1, 2, 7, 40}) {
    CAPTURE(shares);
    Json sum = counted(merged(folder, kPairs, shares));
    sum["jobs"] = 2;
    CHECK(sum == counted(whole));
  }
}

TEST_CASE("all shares of sequences are the whole run, too") {
  const TemporaryFolder folder;
  const Json whole = fuzz(folder, "whole", kSequences, {"--jobs=2"});
  Json sum = counted(merged(folder, kSequences, 3));
  sum["jobs"] = 2;
  CHECK(sum == counted(whole));
}

TEST_CASE("of as many shares as there are turns of the regimes each has one turn") {
  const TemporaryFolder folder;
  const Words three{"--regime=sliver", "--regime=boxes", "--seed=1", "--cases=5", "--no-save"};
  CHECK(fuzz(folder, "first", three, {"--share=0/3"})["cases"] == 2);
  const Json last = fuzz(folder, "last", three, {"--share=2/3"});
  CHECK(last["cases"] == 1);
  CHECK(last["first"] == 2);
  CHECK_THAT(
      run_manifuzz(with(with({"fuzz"}, three), {"--share=0/4"})).err,
      Contains("4 are too many shares of 5 cases, dealt to 2 regimes in turn; use at most 3"));
}

TEST_CASE("what is no share, or a share of what is not known, is one clear line") {
  for (const char* const share : {"3/3", "-1/3", "x", "1", "1/", "/3", "1/2/3", "0/0", " 0/1",
                                  "0x1/3", "0/99999999999999999999", "1.0/3", "0/1 "}) {
    const Outcome outcome =
        run_manifuzz({"fuzz", "--seed=1", "--cases=99", std::string("--share=") + share});
    CAPTURE(share, outcome.err);
    CHECK(outcome.status == 2);
    CHECK(is_one_clear_line(outcome.err));
    CHECK_THAT(outcome.err, Contains("K/N is expected"));
  }
  for (const Words& bad : {Words{"--cases=99"},
                           {"--seed=1"},
                           {"--seed=1", "--seconds=1"},
                           {"--seed=1", "--cases=99", "--until-new"}}) {
    const Outcome outcome = run_manifuzz(with(with({"fuzz"}, bad), {"--share=0/1"}));
    CAPTURE(outcome.err);
    CHECK(outcome.status == 2);
    CHECK(is_one_clear_line(outcome.err));
  }
}

TEST_CASE("a share that is interrupted never ends as one that found something") {
  const TemporaryFolder folder;
  const std::string json = (folder.path() / "run.json").string();
  const Outcome outcome = run_interruptible(
      {"fuzz", "--subject-command", interrupting_blind(folder, 100), "--oracle=clip64",
       "--regime=boxes", "--seed=1", "--cases=100000", "--share=0/2", "--no-save", "--json", json});
  CAPTURE(outcome.err);
  CHECK(outcome.status == 130);
  const Json run = Json::parse(text_of(json));
  CHECK(run["interrupted"] == true);
  CHECK(run["failed"] == true);
}

TEST_CASE("new cases go to the folder that --found names, and known ones are read from both") {
  const TemporaryFolder folder;
  const Json first = fuzz(folder, "one", kPairs, {"--share=0/2"});
  REQUIRE(first["buckets"].size() >= 3);
  for (const Json& bucket : first["buckets"]) {
    CHECK(bucket["file"].get<std::string>().find("/one/") != std::string::npos);
    CHECK(bucket["command"].get<std::string>().find("--found") == std::string::npos);
  }
  CHECK_FALSE(std::filesystem::exists("nothing"));
  for (const Json& bucket : fuzz(folder, "one", kPairs, {"--share=0/2"})["buckets"]) {
    CHECK(bucket["new"] == false);
  }
  folder.write("file", "");
  const Outcome outcome =
      run_manifuzz({"fuzz", "--cases=9", "--found", (folder.path() / "file").string()});
  CHECK(outcome.status == 2);
  CHECK(is_one_clear_line(outcome.err));
  CHECK_THAT(outcome.err, Contains("--found: "));
}
