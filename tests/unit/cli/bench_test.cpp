#include "measure/bench/bench.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "exact/truth.hpp"
#include "report/measurements/measurements.hpp"
#include "support/installed_collider.hpp"
#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

using namespace manifuzz;

TEST_CASE("bench measures every subject and writes what it found") {
  const test::TemporaryFolder folder;
  const std::string json = (folder.path() / "bench.json").string();
  const auto outcome = test::run_manifuzz(
      {"bench", "--quick", "--collider", "clip", "--collider", "batch", "--json", json});
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  const auto report = nlohmann::json::parse(std::ifstream(json));
  CHECK(report.at("machine").contains("instruction_set"));
  REQUIRE(report.at("rows").size() >= 4);
  for (const auto& row : report.at("rows")) {
    CHECK(row.at("ns_per_pair").get<double>() > 0);
    CHECK(row.at("missed") == 0);
    CHECK(row.at("phantom") == 0);
  }
  CHECK(report.at("rows")[0].at("collider") == "box2d");
  CHECK(report.at("rows")[0].at("speedup_over_box2d") == 1.0);
}

TEST_CASE("bench times installed baselines of scenes where nobody is named, no other library") {
  if (!test::installed_collider("box2d3")) return;
  const auto outcome = test::run_manifuzz({"bench", "--quick", "--json", "-"});
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  const auto report = nlohmann::json::parse(outcome.out);
  std::set<std::string> libraries;
  for (const auto& row : report.at("rows")) {
    if (row.contains("ns_without_interface")) libraries.insert(row.at("collider"));
  }
  CHECK(libraries == std::set<std::string>{"interface", "box2d3"});
}

TEST_CASE("bench compares the ways to contact points, and draws what they trade", "[longer]") {
  const test::TemporaryFolder folder;
  const std::string json = (folder.path() / "methods.json").string();
  const std::string picture = (folder.path() / "methods.svg").string();
  const auto outcome =
      test::run_manifuzz({"bench", "--methods", "--quick", "--json", json, "--picture", picture});
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  CHECK(std::filesystem::file_size(picture) > 1000);
  const auto report = nlohmann::json::parse(std::ifstream(json));
  int frames = 0;
  for (const auto& row : report.at("rows")) {
    if (row.at("collider") == "clip") {
      CHECK(row.at("points_missing") == 0);
      CHECK(row.at("extent_lost") == 0);
    }
    if (row.at("input") != "frame") continue;
    ++frames;
    if (row.at("collider") == "clip") CHECK(row.at("frames_to_complete") == 1);
    if (row.at("collider") == "gjk") CHECK(row.at("frames_to_complete").is_null());
  }
  CHECK(frames >= 11);
}

TEST_CASE("bench's errors are those of the same manifolds") {
  const auto workload = draw_workload({find_regime("sliver"), {}, 0.5, 400}, 1);
  REQUIRE(workload);
  const auto errors = measure_errors(own_subjects(), *workload);
  const BenchErrors& of_clip = errors.at("clip");
  const BenchErrors& of_batch = errors.at("batch");
  CHECK(of_clip.cases == 400);
  CHECK(of_batch.cases == 400);
  CHECK(of_batch.of_extent == of_clip.of_extent);
}

TEST_CASE("a workload has the share of touching pairs and the counts that were asked for") {
  const auto workload = draw_workload({find_regime("generic"), 5, 0.25, 40}, 1);
  REQUIRE(workload);
  int touching = 0;
  for (const PairCase& pair : *workload) {
    CHECK(pair.a.polygon.count == 5);
    CHECK(pair.b.polygon.count == 5);
    touching += exact::Truth(pair).separation() <= 0;
  }
  CHECK(touching == 10);
  CHECK_FALSE(draw_workload({find_regime("boxes"), 7, 0.5, 10}, 1));
}

TEST_CASE("the front is what nothing else is left of and below") {
  const auto best = front({{"slow", 3, 1}, {"fast", 1, 2}, {"worse", 2, 2}, {"worst", 3, 3}});
  REQUIRE(best.size() == 2);
  CHECK(best[0].name == "fast");
  CHECK(best[1].name == "slow");
}

TEST_CASE("an output that bench cannot write loses neither the table nor the others") {
  const test::TemporaryFolder folder;
  const std::string picture = (folder.path() / "bench.svg").string();
  const auto outcome = test::run_manifuzz(
      {"bench", "--quick", "--collider", "clip", "--json", "/dev/full", "--picture", picture});
  INFO(outcome.err);
  CHECK(outcome.status == 2);
  CHECK(outcome.out.find("x box2d") != std::string::npos);
  CHECK(outcome.err.find("/dev/full") != std::string::npos);
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  CHECK(test::text_of(picture).find("box2d") != std::string::npos);
}

TEST_CASE("bench refuses what it cannot do in one line") {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"bench", "--collider", "nobody"},
        {"bench", "--quick", "--collider", "clip", "--picture", "a.txt"}}) {
    const test::Outcome outcome = test::run_manifuzz(arguments);
    CHECK(outcome.status == 2);
    CHECK(test::is_one_clear_line(outcome.err));
  }
}
