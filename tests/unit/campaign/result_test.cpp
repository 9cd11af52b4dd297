#include <limits>
#include <set>

#include <catch2/catch.hpp>

#include "base/user_error.hpp"
#include "campaign/result_json.hpp"

using namespace manifuzz;
using Json = nlohmann::ordered_json;

namespace {

const char* const kWrong = "subject/subject_wrong/depth/none/a";
const char* const kOracleWrong = "oracle/oracle_wrong/depth/none/a";

/// A result in which every part has something of its own.
FuzzResult sample() {
  FuzzResult result;
  result.machine = {{"processor", "p"}, {"cores", 2}, {"instruction_set", "sse2"}};
  result.compiler = "g++";
  result.settings = {.subject = "zeta",
                     .oracle = "alpha",
                     .versions = {{"manifuzz", "0.1.0"}, {"zeta", "2"}, {"alpha", "1"}},
                     .tie_bias = 0.5,
                     .radius = 0.25,
                     .judge_every = 7};
  result.jobs = 3;
  result.verdicts = {90, 5, 4, 0, 1};
  result.of_oracle = {0.25, std::numeric_limits<double>::infinity()};
  result.stopped_early = true;
  result.budgets_hold = true;
  result.regimes = {{"boxes", 60, 30, 20, 1}, {"grid", 40, 10, 5, 0}};
  result.ledger = {{"entry", 4, {{"boxes", 3}, {"grid", 1}}, {"grid"}}};
  const double beyond = std::numeric_limits<double>::infinity();
  const std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
  result.buckets = {
      {kOracleWrong, "oracle_wrong", 1, most, 9, "boxes", beyond, "a.json", "x", true},
      {"none/tie/none/none/a", "tie", 5, 3, most, "grid", 0, "", "y", false},
      {"oracle/known/depth/none/a", "known", 4, 3, 8, "boxes", 0.5, "", "z", false}};
  result.parts = {{3, most, {{"boxes", 20}}, 0.5}, {most, 7, {{"boxes", 40}, {"grid", 40}}, 1}};
  return result;
}

FuzzResult read(const Json& json) {
  const JsonTree tree = parse_json(json.dump());
  return read_fuzz_result(JsonView(tree));
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
  CHECK(read(json).buckets[0].magnitude == std::numeric_limits<double>::infinity());
  CHECK(json["cases"] == 100);
  CHECK(json["touching"] == 40);
  CHECK(json["unexplained"] == 1);
}

TEST_CASE("a result of fuzz with any part of another type, or without it, is refused by its path") {
  // These follow from others, and are not read.
  const std::set<std::string> unread{"/seed", "/first", "/seconds", "/cases_per_second",
                                     "/vacuous"};
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

TEST_CASE("a result that contradicts itself is refused by what does not add up") {
  const Json good = json_of(sample());
  const auto refused = [&](const char* path, const Json& value, const std::string& why) {
    Json bad = good;
    bad[Json::json_pointer(path)] = value;
    CAPTURE(path, value.dump());
    CHECK(refusal(bad) == why);
  };
  refused("/verdicts/subject_wrong", 5,
          "$.verdicts.subject_wrong: is 5, but its buckets add up to 0");
  refused("/verdicts/agree", 91, "$.cases: is 100, but the verdicts add up to 101");
  refused("/regimes/0/cases", 61, "$.cases: is 100, but the regimes add up to 101");
  refused("/parts/0/cases/boxes", 21, "$.cases: is 100, but the parts add up to 101");
  refused("/buckets/1/count", std::uint64_t{1} << 60,
          "$.buckets[1].count: 1152921504606846976 is no count; at most 9007199254740992 is "
          "expected");
  refused("/regimes/1/touching", 36, "$.touching: is 40, but the regimes add up to 66");
  refused("/regimes/1/unexplained", 41, "$.regimes[1].unexplained: is 41, more than the cases: 40");
  refused("/regimes/1/name", "boxes", "$.regimes: has boxes twice");
  refused("/ledger/0/hits", 5, "$.ledger[0].hits: is 5, but the regimes add up to 4");
  refused("/buckets/2/verdict", "tie", "$.verdicts.tie: is 5, but its buckets add up to 9");
  refused("/buckets/2/bucket", "none/tie/count/none/a",
          "$.buckets[2].verdict: is not that of the bucket's name");
  refused("/near", 26, "$.near: is 26, but the regimes add up to 25");
  refused("/failed", false, "$.failed: does not follow from what is told beside it");
}

TEST_CASE("a result that counts cases twice is refused") {
  FuzzResult result = sample();
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
  const FuzzResult result = read(json);
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
  FuzzResult result;
  CHECK(has_failed(result));  // no case proves nothing
  result.regimes = {{"boxes", 10, 1, 0, 0}};
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
  result.regimes = {{"boxes", kVacuousCases, 0, 0, 0}};
  CHECK(has_failed(result));
  result.regimes[0].touching = 1;
  CHECK_FALSE(has_failed(result));
}
