#include "campaign/result.hpp"

#include <limits>
#include <set>

#include <catch2/catch.hpp>

#include "base/text.hpp"

using namespace manifuzz;
using Json = nlohmann::ordered_json;

namespace {

const char* const kWrong = "subject/subject_wrong/depth/none/a";
const char* const kOracleWrong = "oracle/oracle_wrong/depth/none/a";

/// A result in which every part has something of its own.
CampaignResult sample() {
  CampaignResult result;
  result.machine = {{"processor", "p"}, {"cores", 2}, {"instruction_set", "sse2"}};
  result.compiler = "g++";
  result.settings.subject = "zeta";
  result.settings.oracle = "alpha";
  result.settings.versions = {{"manifuzz", "0.1.0"}, {"zeta", "2"}, {"alpha", "1"}};
  result.settings.tie_bias.absolute = 0.5;
  result.settings.radius = 0.25;
  result.settings.judge_every = 7;
  result.jobs = 3;
  result.verdicts = {90, 5, 4, 0, 1};
  result.of_oracle[Component::depth] = std::numeric_limits<double>::infinity();
  result.of_oracle[Component::excess] = 0.25;
  result.stopped_early = true;
  result.budgets_hold = true;
  result.regimes = {{{60, 30, 20, 1, 0, 20, 5}, "boxes"}, {{40, 10, 5, 0}, "grid"}};
  result.ledger = {{"entry", 4, {{"boxes", 3}, {"grid", 1}}, {"grid"}}};
  const double beyond = std::numeric_limits<double>::infinity();
  const std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
  result.buckets = {
      {kOracleWrong, "oracle_wrong", 1, most, 9, "boxes", {beyond}, "a.json", "x", true},
      {"none/tie/none/none/a", "tie", 5, 3, most, "grid", {0}, "", "y", false},
      {"oracle/known/depth/none/a", "known", 4, 3, 8, "boxes", {0.5}, "", "z", false}};
  result.buckets[2].error.errors[Component::position] = 0.5;
  for (BucketResult& found : result.buckets) found.regimes = {{"boxes", 1}};
  result.hints = {{"reversed-normal", 30, 29, "the normal points from B to A"}};
  result.stale = {"b.json"};
  result.buckets[0].agreed = {{"boxes", 1}};
  result.risk_error = error_of_look(2);
  result.ended_by = "cases";
  result.parts = {{3, most, {{"boxes", 20}}, 0.5}, {most, 7, {{"boxes", 40}, {"grid", 40}}, 1}};
  return result;
}

CampaignResult read(const Json& json) {
  const JsonTree tree = parse_json(json.dump());
  return read_campaign_result(JsonView(tree));
}

/// What is said against it, or nothing.
std::string refusal(const Json& json) {
  try {
    read(json);
    return "";
  } catch (const UserError& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("a result of fuzz is read back as it was written, infinity too") {
  const Json json = json_of(sample());
  CHECK(json_of(read(json)).dump() == json.dump());
  CHECK(read(json).buckets[0].error.magnitude == std::numeric_limits<double>::infinity());
  CHECK(json["cases"] == 100);
  CHECK(json["touching"] == 40);
  CHECK(json["unexplained"] == 1);
}

TEST_CASE("a result of fuzz with any part of another type, or without it, is refused by its path") {
  // What follows from other members is not read.
  const std::set<std::string> unread{"/seed",     "/first",  "/seconds", "/cases_per_second",
                                     "/agreeing", "/vacuous"};
  const Json good = json_of(sample());
  const Json parts = good.flatten();
  CHECK(parts.size() > 80);
  for (const auto& [path, value] : parts.items()) {
    for (const Json& other : {Json(-1), Json(true), Json("x"), Json::array(), Json::object()}) {
      if (other.type() == value.type()) continue;
      Json bad = good;
      bad[Json::json_pointer(path)] = other;
      CAPTURE(path, other.dump());
      CHECK(refusal(bad).starts_with("$") == !unread.contains(path));
    }
  }
  for (const char* const key :
       {"machine", "compiler", "versions", "jobs", "verdicts", "regimes", "buckets"}) {
    Json bad = good;
    bad.erase(key);
    CHECK_THROWS_AS(read(bad), UserError);
    bad[key] = nullptr;
    CHECK_THROWS_AS(read(bad), UserError);
  }
}

TEST_CASE("sums are those of the rows, whatever is written beside them") {
  Json bad = json_of(sample());
  for (const char* const sum : {"cases", "touching", "near", "unexplained"}) bad[sum] = 12345;
  bad["verdicts"]["subject_wrong"] = 7;
  bad["failed"] = false;
  const Json again = json_of(read(bad));
  CHECK(again["cases"] == 100);
  CHECK(again["touching"] == 40);
  CHECK(again["near"] == 25);
  CHECK(again["unexplained"] == 8);
  CHECK(again["failed"] == true);
}

TEST_CASE("a count is so small that sums of it are exact") {
  Json bad = json_of(sample());
  bad["buckets"][1]["count"] = std::uint64_t{1} << 60;
  CHECK(refusal(bad) ==
        "$.buckets[1].count: 1152921504606846976 is no count; at most 9007199254740992 is "
        "expected");
}

TEST_CASE("a result that counts cases twice is refused") {
  CampaignResult result = sample();
  result.parts = {{3, 0, {{"boxes", 20}}, 0.5}, {3, 19, {{"boxes", 40}, {"grid", 40}}, 1}};
  CHECK(refusal(json_of(result)) == "$.parts: has cases twice");
  result.parts[1].first = 20;
  CHECK(refusal(json_of(result)).empty());
}

TEST_CASE("a result without parts is one, and later keys are let be") {
  Json json = json_of(sample());
  json.erase("parts");
  json["later"] = 1;
  CHECK_FALSE(refusal(json).empty());  // of several seeds
  json["seed"] = 4;
  json["first"] = 2;
  const CampaignResult result = read(json);
  CHECK(result.parts.size() == 1);
  CHECK(result.seed() == 4U);
  CHECK(result.first() == 2);
  CHECK(result.seconds() == 1.5);
  for (const char* const key : {"seed", "seconds"}) {
    Json bad = json;
    bad.erase(key);
    CHECK_FALSE(refusal(bad).empty());
  }
}

TEST_CASE(
    "a result has failed by a wrong subject, a new fault of the oracle, a budget, or nothing") {
  CampaignResult result;
  CHECK(has_failed(result));  // no case proves nothing
  result.regimes = {{{10, 1, 0, 0}, "boxes"}};
  CHECK_FALSE(has_failed(result));
  result.buckets = {{.bucket = kOracleWrong}};
  CHECK_FALSE(has_failed(result));
  result.buckets[0].is_new = true;
  CHECK(has_failed(result));
  result.buckets = {{.bucket = kWrong}};
  CHECK(has_failed(result));
  result.buckets = {{.bucket = "what/nobody/knows"}};
  CHECK(has_failed(result));
  result.buckets.clear();
  result.ledger = {{"entry", 1, {}, {"boxes"}}};
  CHECK(has_failed(result));
  result.ledger.clear();
  result.regimes = {{{kVacuousCases, 0, 0, 0}, "boxes"}};
  CHECK(has_failed(result));
  result.regimes[0].touching = 1;
  CHECK_FALSE(has_failed(result));
}
