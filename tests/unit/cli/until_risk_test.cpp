#include <algorithm>
#include <map>

#include <catch2/catch.hpp>

#include "unit/cli/merge_runs.hpp"

using namespace manifuzz::test;
using Catch::Contains;

namespace {

using Words = std::vector<std::string>;

/// All agreeing cases are judged, so that a few thousand cases are enough.
const Words kCampaign{"fuzz",           "--subject=clip64", "--oracle=clip", "--regime=sliver",
                      "--regime=boxes", "--judge-every=1",  "--seed=5",      "--corpus=nothing",
                      "--no-save",      "--until-risk=0.01"};

Json parsed(const Outcome& outcome) {
  INFO(outcome.err);
  Json json = Json::parse(outcome.out, nullptr, false);
  REQUIRE(json.is_object());
  return json;
}

/// All but what clocks and jobs make otherwise.
Json counted(Json json) {
  for (const char* key : {"jobs", "seconds", "cases_per_second"}) json.erase(key);
  return json;
}

Json run_of(const Words& words) {
  return parsed(run_manifuzz(with(words, {"--json=-"})));
}

const Json& row_of(const Json& run, const std::string& regime) {
  const auto row =
      std::ranges::find_if(run["risk"], [&](const Json& one) { return one["regime"] == regime; });
  REQUIRE(row != run["risk"].end());
  return *row;
}

/// Buckets that the chosen regimes met in one case together.
int met_once(const Json& run, const Words& regimes, bool only_wrong) {
  return static_cast<int>(std::ranges::count_if(run["buckets"], [&](const Json& found) {
    int count = 0;
    for (const std::string& regime : regimes) count += found["regimes"].value(regime, 0);
    const bool is_wrong = !found["bucket"].get<std::string>().starts_with("none/");
    return count == 1 && (is_wrong || !only_wrong);
  }));
}

void check_refused(const Words& words, const std::string& complaint) {
  const Outcome outcome = run_manifuzz(with({"fuzz", "--no-save"}, words));
  CAPTURE(words, outcome.err);
  CHECK(outcome.status == 2);
  CHECK(outcome.out.empty());
  CHECK(is_one_clear_line(outcome.err));
  CHECK_THAT(outcome.err, Contains(complaint));
}

}  // namespace

TEST_CASE("a campaign ends where the risk is low enough, the same whatever the jobs") {
  const Json one = run_of(with(kCampaign, {"--jobs=1", "--cases=1000000"}));
  CHECK(counted(one) == counted(run_of(with(kCampaign, {"--jobs=2", "--cases=1000000"}))));
  CHECK(one["ended_by"] == "risk");
  CHECK(row_of(one, "all")["high"] <= 0.01);
  const auto cases = one["cases"].get<std::uint64_t>();
  CHECK(cases % 1024 == 0);
  CHECK((cases & (cases - 1)) == 0);
  CHECK(cases < 100'000);
  // At the look before, the risk was higher.
  const Json before = run_of(with(kCampaign, {"--cases=" + std::to_string(cases / 2)}));
  CHECK(before["ended_by"] == "cases");
  CHECK(row_of(before, "all")["high"] > 0.01);
  const Outcome screen = run_manifuzz(kCampaign);
  CHECK_THAT(screen.out, Contains("a bucket not yet seen: ") &&
                             Contains("\nended by --until-risk: the risk is at most "));
}

TEST_CASE("before the risk is low enough, cases or seconds may end it, and it says which") {
  Words impossible = kCampaign;
  impossible.back() = "--until-risk=1e-9";
  const Json by_cases = run_of(with(impossible, {"--cases=3000"}));
  CHECK(by_cases["ended_by"] == "cases");
  CHECK(by_cases["cases"] == 3000);
  const Outcome screen = run_manifuzz(with(impossible, {"--cases=3000"}));
  CHECK(screen.status == 0);
  CHECK_THAT(screen.out,
             Contains("\nended by --cases, before --until-risk: the risk is at most ") &&
                 Contains(" in a million after 3000 cases\n"));
  const Json by_seconds = run_of(with(impossible, {"--seconds=0.5"}));
  CHECK(by_seconds["ended_by"] == "seconds");
  CHECK(by_seconds["seconds"].get<double>() >= 0.5);
}

TEST_CASE("every campaign has the risk of each regime and of all, from what it counts") {
  const TemporaryFolder folder;
  const Words words{"fuzz",
                    "--seed=1",
                    "--cases=6000",
                    "--subject=box2d",
                    "--oracle=clip64",
                    "--corpus=nothing",
                    "--no-save"};
  const Json run = run_of(words);
  CHECK(counted(run) == counted(run_of(with(words, {"--jobs=1"}))));
  CHECK(run["risk"].size() == run["regimes"].size());  // the corpus has none, and all has one
  Words keys;
  for (const auto& [key, value] : row_of(run, "all").items()) keys.push_back(key);
  CHECK(keys == Words{"regime", "cases", "once", "next", "low", "high", "wrong"});
  Words names;
  std::uint64_t cases = 0;
  for (const Json& regime : run["regimes"]) {
    const auto name = regime["name"].get<std::string>();
    if (name == "corpus") continue;
    names.push_back(name);
    cases += regime["cases"].get<std::uint64_t>();
    const Json& row = row_of(run, name);
    CHECK(row["cases"] == regime["cases"]);
    CHECK(row["once"] == met_once(run, {name}, false));
    CHECK(row["wrong"]["once"] == met_once(run, {name}, true));
    CHECK(row["low"] <= row["next"]);
    CHECK(row["next"] <= row["high"]);
  }
  const Json& all = row_of(run, "all");
  CHECK(all["cases"] == cases);
  CHECK(all["once"] == met_once(run, names, false));
  CHECK(all["wrong"]["once"] == met_once(run, names, true));
  CHECK(all["wrong"]["once"] > 0);
  CHECK_THAT(run_manifuzz(with(words, {"--verbose"})).out, Contains("\nall "));
}

TEST_CASE("known findings, explained or not, count like any others") {
  const TemporaryFolder folder;
  const Words words{"fuzz", "--seed=1", "--cases=3000", "--regime=tie_bias", "--regime=sliver"};
  const std::string corpus = "--corpus=" + (folder.path() / "corpus").string();
  const Json first = run_of(with(words, {corpus, "--ties", "--shrink-seconds=0"}));
  const Json again = run_of(with(words, {corpus}));
  REQUIRE(first["buckets"][0]["new"] == true);
  REQUIRE(again["buckets"][0]["new"] == false);
  CHECK(first["verdicts"]["known"] > 0);
  CHECK(first["risk"] == again["risk"]);
}

TEST_CASE("merged runs have the risk of all their cases, and with an older one none") {
  const TemporaryFolder folder;
  count(folder, "a", 0, 3000);
  Json older = count(folder, "b", 1500, 3000);
  count(folder, "whole", 0, 6000);
  REQUIRE(merge(folder, {"a.json", "b.json"}, "all").status == 0);
  const Json all = Json::parse(text_of(folder.path() / "all.json"));
  CHECK(all["risk"] == Json::parse(text_of(folder.path() / "whole.json"))["risk"]);
  for (const char* key : {"risk", "risk_error"}) older.erase(key);
  folder.write("older.json", older.dump());
  REQUIRE(merge(folder, {"a.json", "older.json"}, "without").status == 0);
  const Json without = Json::parse(text_of(folder.path() / "without.json"));
  CHECK(without["cases"] == 6000);
  CHECK_FALSE(without.contains("risk"));
}

TEST_CASE("a risk that cannot be is refused") {
  for (const char* risk : {"0", "-0.5", "1.5", "nan", "x", ""}) {
    check_refused({std::string("--until-risk=") + risk, "--cases=100"}, "--until-risk");
  }
  check_refused({"--until-risk=0.1", "--until-new"}, "--until-new");
  check_refused({"--until-risk=0.1", "--seed=1", "--cases=100", "--share=0/2"}, "--share");
  check_refused({"--until-risk=0.1", "--regime=corpus"}, "the regime corpus");
}
