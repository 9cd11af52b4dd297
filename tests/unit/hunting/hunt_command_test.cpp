#include <filesystem>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/interruption.hpp"
#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

using namespace manifuzz::test;
using Json = nlohmann::ordered_json;

namespace {

std::vector<std::string> hunt(const TemporaryFolder& folder, const std::vector<std::string>& more) {
  return with({"hunt", "--corpus", (folder.path() / "corpus").string()}, more);
}

}  // namespace

TEST_CASE("a hunt's JSON has every key that is promised") {
  const TemporaryFolder folder;
  const Outcome outcome =
      run_manifuzz(hunt(folder, {"--seed", "1", "--cases", "3000", "--no-save", "--json", "-"}));
  CAPTURE(outcome.err);
  const Json json = Json::parse(outcome.out);
  for (const char* const key :
       {"machine", "compiler", "seed", "versions", "cases", "seconds", "generations", "cells",
        "cells_drawn", "pairs_of_conditions", "pairs_of_conditions_drawn", "rows", "buckets"}) {
    CHECK(json.contains(key));
  }
  CHECK(json["cases"] == 3000);
  CHECK(json["cells"] > json["pairs_of_conditions"]);
  CHECK(json["pairs_of_conditions"] > json["generations"]);
  std::vector<std::string> measures;
  for (const Json& row : json["rows"]) {
    measures.push_back(row.at("measure"));
    for (const char* const key : {"worst", "worst_drawn", "file"}) CHECK(row.contains(key));
  }
  for (const char* const measure : {"error", "bound_share", "missed"}) {
    CHECK(std::ranges::count(measures, measure) == 1);
  }
  CHECK(outcome.out.find("\"/") == std::string::npos);  // no absolute path
}

TEST_CASE("without drawn cases nothing is compared") {
  const TemporaryFolder folder;
  const Outcome outcome = run_manifuzz(
      hunt(folder, {"--seed", "1", "--cases", "1500", "--no-save", "--no-compare", "--json", "-"}));
  const Json json = Json::parse(outcome.out);
  CHECK(json["cells_drawn"].is_null());
  for (const Json& row : json["rows"]) CHECK(row["worst_drawn"].is_null());
}

TEST_CASE("a hunt says what is wrong with what it is given, in a line") {
  const TemporaryFolder folder;
  const std::string broken = folder.write("broken.json", "{\"format\": \"manifuzz/case/1\"}");
  const std::vector<std::vector<std::string>> wrong{
      {"--measure", "speed"}, {"--cases", "0"},        {"--seconds", "-1"},
      {"--from", "nowhere"},  {"--from", broken},      {"--regime", "sliding"},
      {"--jobs", "0"},        {"--subject", "cached"}, {"--cases", "10", "--seconds", "1"}};
  for (const std::vector<std::string>& options : wrong) {
    CAPTURE(options);
    const Outcome outcome = run_manifuzz(hunt(folder, options));
    CHECK(outcome.status == 2);
    CHECK(std::ranges::count(outcome.err, '\n') == 1);
    CHECK(outcome.out.empty());
  }
}

TEST_CASE("a hunt of a collider that is wrong saves what it finds, and its worst cases are listed",
          "[longer]") {
  const TemporaryFolder folder;
  const std::string corpus = (folder.path() / "corpus").string();
  const std::string silent = "sh " + folder.write("silent.sh",
                                                  "while read -r line; do\n"
                                                  "  echo '{\"points\": []}'\n"
                                                  "done\n");
  const Outcome outcome = run_manifuzz(
      hunt(folder, {"--subject-command", silent, "--oracle", "clip", "--regime", "boxes", "--seed",
                    "1", "--cases", "600", "--no-compare", "--json", "-"}));
  CAPTURE(outcome.err, outcome.out);
  CHECK(outcome.status == 1);
  const Json json = Json::parse(outcome.out);
  REQUIRE(json["buckets"].size() > 0);
  for (const Json& bucket : json["buckets"]) {
    if (bucket["verdict"] != "subject_wrong") continue;
    CHECK(std::filesystem::exists(bucket["file"].get<std::string>()));
  }
  for (const Json& row : json["rows"]) {
    if (row["measure"] != "missed") continue;
    CHECK(row["worst"] > 0.1);
    CHECK(std::filesystem::exists(row["file"].get<std::string>()));
  }
}

TEST_CASE("a hunt that is interrupted keeps what it found") {
  const TemporaryFolder folder;
  const std::string json = (folder.path() / "hunt.json").string();
  const std::string once = (folder.path() / "once").string();
  const std::string ending = "sh " + folder.write("ending.sh",
                                                  "n=0\nwhile read -r line; do\n"
                                                  "  n=$((n + 1))\n"
                                                  "  if [ $n -eq 300 ]; then mkdir '" +
                                                      once +
                                                      "' 2>/dev/null && kill -INT "
                                                      "$MANIFUZZ_PROCESS; fi\n"
                                                      "  echo '{\"points\": []}'\n"
                                                      "done\n");
  const Outcome outcome = run_interruptible(
      hunt(folder, {"--subject-command", ending, "--oracle", "clip64", "--regime", "boxes",
                    "--cases", "1000000", "--seed", "1", "--json", json}));
  CAPTURE(outcome.err, outcome.out);
  CHECK(outcome.status == 1);  // it found something
  const Json run = Json::parse(text_of(json));
  CHECK(run["interrupted"] == true);
  CHECK(run["cases"] < 1000000);
  REQUIRE(run["buckets"].size() > 0);
  for (const Json& bucket : run["buckets"]) {
    if (bucket["verdict"] != "tie")
      CHECK(std::filesystem::exists(bucket["file"].get<std::string>()));
  }
}

TEST_CASE("a hunt that is to begin with cases, and finds none, says so") {
  const TemporaryFolder folder;
  const std::filesystem::path empty = folder.path() / "empty";
  std::filesystem::create_directory(empty);
  const Outcome outcome =
      run_manifuzz(hunt(folder, {"--from", empty.string(), "--cases", "10", "--seed", "1"}));
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Catch::Contains("--from: no case was found"));
  CHECK(is_one_clear_line(outcome.err));
}
