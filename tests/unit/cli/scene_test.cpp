#include <fstream>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "engines/asked_engines.hpp"
#include "measure/scene/scene_run.hpp"
#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

using namespace manifuzz;

namespace {

/// In the order of a scene's rows.
std::vector<std::string> baseline_names() {
  std::vector<std::string> names{"box2d"};
  for (const EngineTimedWorld& world : installed_timed_worlds()) names.push_back(world.name);
  names.emplace_back("afresh");
  return names;
}

}  // namespace

TEST_CASE("scene goes through every scene, with the contacts of all pairs afresh") {
  const test::TemporaryFolder folder;
  const std::string json = (folder.path() / "scene.json").string();
  const std::string frame = (folder.path() / "frame.svg").string();
  const auto outcome = test::run_manifuzz(
      {"scene", "--bodies", "60", "--steps", "5", "--json", json, "--frame", frame});
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  const auto report = nlohmann::json::parse(std::ifstream(json));
  const std::vector<std::string> baselines = baseline_names();
  REQUIRE(report.at("rows").size() == scene_specs().size() * baselines.size());
  std::size_t i = 0;
  for (const auto& row : report.at("rows")) {
    CAPTURE(row.at("scene"));
    CHECK(row.at("baseline") == baselines[i++ % baselines.size()]);
    CHECK(row.at("bodies") == 60);
    CHECK(row.at("mismatches") == 0);
    CHECK(row.at("mode") == "strict");
    const auto& skipped = row.at("skipped");
    std::size_t sum = row.at("computed").get<std::size_t>();
    for (const auto& [reason, count] : skipped.items()) sum += count.get<std::size_t>();
    CHECK(sum == row.at("candidates").get<std::size_t>());
    CHECK(skipped.at("recycled") == 0);
    for (const char* const key :
         {"moving", "steps", "ns_per_step", "speedup_over_box2d", "speedup_over_afresh", "bytes",
          "baseline_ns_per_step", "speedup_over_baseline"}) {
      CHECK(row.at(key).is_number());
    }
  }
  CHECK(test::text_of(frame).find("class=\"contact\"") != std::string::npos);
}

TEST_CASE("scene has a row a baseline, of which each has all of the scene") {
  const auto outcome = test::run_manifuzz(
      {"scene", "--scene", "pile", "--bodies", "300", "--steps", "6", "--json", "-"});
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  const auto report = nlohmann::json::parse(outcome.out);
  const auto& rows = report.at("rows");
  const auto contacts = rows.at(0).at("contacts").get<double>();
  for (const auto& row : rows) {
    CAPTURE(row.at("baseline"));
    for (const auto& [key, value] : row.items()) {
      const bool is_of_baseline = key.find("baseline") != std::string::npos;
      if (!is_of_baseline) CHECK(value == rows.at(0).at(key));
    }
    // A world says itself what touches.
    if (row.at("baseline") == "box2d") continue;
    CHECK(row.at("baseline_contacts").get<double>() == Approx(contacts).epsilon(0.1));
  }
  const auto& of_box2d = rows.at(0);
  CHECK(of_box2d.at("speedup_over_baseline") == of_box2d.at("speedup_over_box2d"));
  CHECK(of_box2d.at("baseline_contacts").is_null());
  CHECK(rows.back().at("speedup_over_baseline") == of_box2d.at("speedup_over_afresh"));
  CHECK(rows.back().at("baseline_contacts") == of_box2d.at("contacts"));
}

TEST_CASE("scene runs steps on threads, whose contacts and counts are those of one") {
  const auto rows_on = [](const std::string& threads) {
    const auto outcome = test::run_manifuzz({"scene", "--scene", "stirred", "--bodies", "200",
                                             "--steps", "6", "--threads", threads, "--json", "-"});
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    return nlohmann::json::parse(outcome.out).at("rows").at(0);
  };
  const auto one = rows_on("1");
  const auto two = rows_on("2");
  CHECK(one.at("speedup_over_one_thread") == 1);
  CHECK(one.at("warm_speedup_over_one_thread") == 1);
  CHECK(two.at("warm_speedup_over_one_thread") > 0);
  CHECK(two.at("threads") == 2);
  CHECK(two.at("mismatches") == 0);
  for (const char* const key :
       {"skipped", "computed", "left_boxes", "proofs", "contacts", "pairs"}) {
    CHECK(one.at(key) == two.at(key));
  }
  const auto refused = test::run_manifuzz({"scene", "--threads", "2", "--mode", "recycle"});
  CHECK(refused.status == 2);
  CHECK(test::is_one_clear_line(refused.err));
}

TEST_CASE("scene recycles on request, and says what that skips and costs") {
  const test::TemporaryFolder folder;
  const std::string json = (folder.path() / "scene.json").string();
  const std::string plot = (folder.path() / "recycling.svg").string();
  const auto outcome =
      test::run_manifuzz({"scene", "--scene", "pyramid", "--bodies", "100", "--steps", "8",
                          "--mode", "recycle", "--json", json, "--recycling", plot});
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  const auto report = nlohmann::json::parse(std::ifstream(json));
  const auto& row = report.at("rows").at(0);
  CHECK(row.at("mode") == "recycle");
  CHECK(row.at("mismatches").is_null());
  CHECK(row.at("skipped").at("recycled").get<int>() > 0);
  const auto& points = report.at("recycling").at(0).at("points");
  REQUIRE(points.size() == kRecyclingMotions.size());
  CHECK(points.front().at("skipped") == 0.0);
  CHECK(points.front().at("depth").at("max").get<double>() < 1e-5);
  CHECK(points.back().at("skipped").get<double>() > 0.9);
  CHECK(points.back().at("depth").at("p999") > points.front().at("depth").at("p999"));
  CHECK(std::filesystem::exists(plot));
}

TEST_CASE("what recycling costs is drawn without a warning where it skips nothing") {
  const test::TemporaryFolder folder;
  const std::string plot = (folder.path() / "recycling.svg").string();
  const auto outcome = test::run_manifuzz(
      {"scene", "--scene", "still", "--bodies", "100", "--steps", "2", "--recycling", plot});
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  CHECK(std::filesystem::exists(plot));
}

TEST_CASE("scene refuses what it does not know") {
  const auto unknown = test::run_manifuzz({"scene", "--scene", "avalanche"});
  CHECK(unknown.status == 2);
  CHECK(unknown.err.find("there is no scene 'avalanche'; there are pile") != std::string::npos);
  CHECK(test::run_manifuzz({"scene", "--bodies", "3"}).status == 2);
  CHECK(test::run_manifuzz({"scene", "--scaling", "plot.pdf"}).status == 2);
  CHECK(test::run_manifuzz({"scene", "--bodies", "10", "--scaling", "plot.svg"}).status == 2);
  CHECK(test::run_manifuzz({"scene", "--frame", "frame.png"}).status == 2);
  CHECK(test::run_manifuzz({"scene", "--mode", "loose"}).status == 2);
  CHECK(test::run_manifuzz({"scene", "--recycled-motion", "0.1"}).status == 2);
  CHECK(test::run_manifuzz({"scene", "--mode", "recycle", "--recycled-motion", "1e-50"}).status ==
        2);
}

TEST_CASE("a scene has the bodies that were asked for, the same each time") {
  for (const SceneSpec& spec : scene_specs()) {
    CAPTURE(spec.name);
    for (const std::size_t bodies : {20, 600}) {
      const Trajectory once = spec.make(bodies, 3);
      const Trajectory twice = spec.make(bodies, 3);
      CHECK(once.start.size() == bodies);
      REQUIRE(once.steps.size() == 3);
      for (std::size_t step = 0; step < 3; ++step) {
        REQUIRE(once.steps[step].size() == twice.steps[step].size());
        for (std::size_t i = 0; i < once.steps[step].size(); ++i) {
          CHECK(once.steps[step][i].body == twice.steps[step][i].body);
          CHECK(once.steps[step][i].pose == twice.steps[step][i].pose);
        }
      }
    }
  }
}

TEST_CASE("the fitted exponent is that of a power") {
  CHECK(*fitted_exponent({{1, 2}, {2, 8}, {4, 32}}) == Approx(2));
  CHECK(!fitted_exponent({{3, 1}}));
}
