#include <limits>

#include <catch2/catch.hpp>

#include "cases/user_error.hpp"
#include "cli/fuzz_result_json.hpp"

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
  result.seed = std::numeric_limits<std::uint64_t>::max();
  result.versions = {{"manifuzz", "0.1.0"}, {"zeta", "2"}, {"alpha", "1"}};
  result.subject = "zeta";
  result.oracle = "alpha";
  result.seconds = 1.5;
  result.jobs = 3;
  result.verdicts = {90, 5, 4, 0, 1};
  result.of_oracle = {0.25, std::numeric_limits<double>::infinity()};
  result.stopped_early = true;
  result.first = 7;
  result.budgets_hold = true;
  result.regimes = {{"boxes", 60, 30, 20, 1}, {"grid", 40, 10, 5, 0}};
  result.ledger = {{"entry", 4, {{"boxes", 3}, {"grid", 1}}, {"grid"}}};
  result.buckets = {{kOracleWrong, "oracle_wrong", 1, 9, "boxes",
                     std::numeric_limits<double>::infinity(), "a.json", "manifuzz fuzz", true}};
  result.parts = {{std::nullopt, 7, {{"boxes", 60}}}};
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
  const Json good = json_of(sample());
  const Json parts = good.flatten();
  for (const auto& [path, value] : parts.items()) {
    for (const Json& other : {Json(-1), Json(true), Json("x"), Json::array(), Json::object()}) {
      Json bad = good;
      bad[Json::json_pointer(path)] = other;
      CAPTURE(path, other.dump());
      const std::string why = refusal(bad);
      CHECK((why.empty() || why.starts_with("$")));
      if (value.is_string()) CHECK(why.empty() == other.is_string());
    }
  }
  for (const char* const key : {"machine", "compiler", "seed", "versions", "seconds", "jobs",
                                "verdicts", "regimes", "buckets"}) {
    Json bad = good;
    bad.erase(key);
    CHECK_THROWS_AS(read(bad), UserError);
    bad[key] = "x";
    if (std::string_view(key) != "compiler") CHECK_THROWS_AS(read(bad), UserError);
  }
}

TEST_CASE(
    "a result has failed by a wrong subject, a new fault of the oracle, a budget, or nothing") {
  FuzzResult result;
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
