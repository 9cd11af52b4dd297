#include <algorithm>
#include <filesystem>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/interruption.hpp"
#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"
#include "unit/cli/stress_runs.hpp"

using namespace manifuzz::test;
using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

TEST_CASE("stress writes a table, JSON and pictures of what it measured") {
  const TemporaryFolder folder;
  const fs::path json = folder.path() / "stress.json";
  const fs::path pictures = folder.path() / "pictures";
  const Outcome outcome = run_small({"--json", json.string(), "--pictures", pictures.string()});
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  CHECK(outcome.out.find("distance") != std::string::npos);
  CHECK(outcome.out.find("never") != std::string::npos);
  const Json report = Json::parse(text_of(json));
  for (const char* key : {"machine", "compiler", "seed", "versions"}) CHECK(report.contains(key));
  CHECK(report.at("interrupted") == false);
  CHECK(report.at("walks").size() == 4);  // the ideal, clip, clip with a bias, box2d
  REQUIRE(report.at("sweeps").size() == 6);
  for (const Json& row : report.at("sweeps")) {
    CHECK(row.at("steps").size() >= 20);
    CHECK(row.at("worst").at("case").contains("a"));
    for (const Json& step : row.at("steps")) {
      CHECK(step.at("cases") == 100);
      for (const char* key : {"x", "ill_posed", "missed", "phantom"}) CHECK(step.contains(key));
      for (const char* key : {"depth", "position", "normal"}) {
        CHECK(step.at(key).at("median") <= step.at(key).at("p999"));
        CHECK(step.at(key).at("p999") <= step.at(key).at("max"));
      }
    }
    if (row.at("collider") == "clip") CHECK(row.at("breaking_point").is_null());
    if (row.at("collider") == "box2d" && row.at("sweep") == "distance") {
      CHECK(row.at("breaking_point") > 1e4);
    }
  }
  for (const char* name : {"distance.svg", "distance.png", "collinear.svg", "collinear.png"}) {
    CHECK(fs::file_size(pictures / name) > 1000);
  }
}

TEST_CASE("stress measures the same, whatever the jobs") {
  const auto figures = [](const char* jobs) {
    Json report = Json::parse(run_small({"--jobs", jobs, "--json", "-"}).out);
    report.erase("seconds");
    return report;
  };
  CHECK(figures("1") == figures("3"));
}

TEST_CASE("an output that cannot be written loses neither the table nor the others") {
  const TemporaryFolder folder;
  const std::string stored = (folder.path() / "stored.json").string();
  const fs::path pictures = folder.path() / "pictures";
  fs::create_directories(pictures / "distance.png");
  const Outcome outcome =
      run_small({"--json", "/dev/full", "--store", stored, "--pictures", pictures.string()});
  INFO(outcome.err);
  CHECK(outcome.status == 2);
  CHECK(outcome.out.find("breaking points") != std::string::npos);
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 2);
  CHECK(text_of(stored).find("breaking_point") != std::string::npos);
  CHECK(fs::file_size(pictures / "collinear.png") > 1000);
}

TEST_CASE("a sweep that is named twice is run once, a collider refused") {
  const Outcome sweeps = run_distance({"--sweep", "distance", "--json", "-"});
  CHECK(Json::parse(sweeps.out).at("sweeps").size() == 3);
  const TemporaryFolder folder;
  const std::string ideal = folder.write("ideal", "echo '{\"declaration\": {}}'; cat\n");
  fs::permissions(ideal, fs::perms::owner_all);
  for (const auto& [option, value] :
       {std::pair("--collider", std::string("clip")), std::pair("--collider-command", ideal)}) {
    const Outcome outcome = run_distance({option, value});
    INFO(outcome.err);
    CHECK(outcome.status == 2);
    CHECK(is_one_clear_line(outcome.err));
    CHECK(outcome.err.find("more than one") != std::string::npos);
  }
}

TEST_CASE("the worst cases are saved, and replay finds them as they were") {
  const TemporaryFolder folder;
  const fs::path corpus = folder.path() / "corpus";
  REQUIRE(run_small({"--save", corpus.string()}).status == 0);
  int of_clip = 0;
  int of_box2d = 0;
  for (const auto& entry : fs::recursive_directory_iterator(corpus)) {
    const std::string name = entry.path().filename().string();
    of_clip += name.starts_with("stress-") && name.ends_with("-clip.json") ? 1 : 0;
    of_box2d += name.starts_with("stress-") && name.ends_with("-box2d.json") ? 1 : 0;
  }
  CHECK(of_clip == 2);
  CHECK(of_box2d >= 1);
  const std::string far = text_of(corpus / "seeds" / "stress-distance-clip.json");
  CHECK(Json::parse(far).at("expect").at("verdict") != "ill_posed");
  const Outcome milder = run_manifuzz({"stress", "--sweep", "distance", "--collider", "clip",
                                       "--cases", "3", "--save", corpus.string()});
  CHECK(milder.err.find("stress-distance-clip.json is worse") != std::string::npos);
  CHECK(text_of(corpus / "seeds" / "stress-distance-clip.json") == far);
  const Outcome replayed = run_manifuzz({"replay", corpus.string()});
  INFO(replayed.out);
  CHECK(replayed.status == 0);
}

TEST_CASE("an interrupted stress keeps what it measured, and compares nothing else") {
  const TemporaryFolder folder;
  const std::string json = (folder.path() / "stress.json").string();
  const std::string baseline = folder.write(
      "baseline.json",
      R"({"format": "manifuzz/breaking_points/1", "seed": 1, "flush_to_zero": false, "cases": 1000,
          "sweeps": {"touch": {"clip": null}, "large": {"clip": null}}, "walks": {}})");
  const Outcome outcome =
      run_interruptible({"stress", "--sweep", "touch", "--sweep", "large", "--cases", "1000",
                         "--jobs", "1", "--collider-command", interrupting_clip(folder, 2500),
                         "--json", json, "--baseline", baseline});
  INFO(outcome.err);
  CHECK(outcome.status == 1);
  CHECK(outcome.out.find("large: clip: 0 of") != std::string::npos);
  CHECK(outcome.out.find("interrupted") != std::string::npos);
  const Json report = Json::parse(text_of(json));
  CHECK(report.at("interrupted") == true);
  const Json& steps = report.at("sweeps").at(1).at("steps");  // of clip over touch
  CHECK(steps.size() >= 2);
  for (const Json& step : steps) CHECK(step.at("cases") == 1000);
}

TEST_CASE("of a collider that answers nothing no breaking point is said") {
  const TemporaryFolder folder;
  const std::string idle = folder.write("idle",
                                        "echo '{\"declaration\": {}}'\nwhile read -r line; do echo "
                                        "'{\"unsupported\": \"idle\"}'; done\n");
  fs::permissions(idle, fs::perms::owner_all);
  const Outcome outcome = run_distance({"--collider-command", idle});
  INFO(outcome.out << outcome.err);
  CHECK(outcome.status == 0);
  CHECK(outcome.out.find("distance: cases unsupported: idle 100%") != std::string::npos);
  CHECK(outcome.out.find("  -  world lengths") != std::string::npos);
}

TEST_CASE("colliders without subnormal numbers are measured too") {
  const Outcome outcome = run_manifuzz(
      {"stress", "--sweep", "small", "--cases", "20", "--collider", "clip", "--flush-to-zero"});
  CHECK(outcome.status == 0);
  CHECK(outcome.out.find("small") != std::string::npos);
}

TEST_CASE("stress refuses what it cannot do in one line") {
  const TemporaryFolder folder;
  const std::string other = folder.write("other.json", "{\"format\": \"another\"}");
  const std::string no_json = folder.write("no.json", "nonsense");
  const std::string stored = (folder.path() / "stored.json").string();
  REQUIRE(run_small({"--store", stored}).status == 0);
  const std::vector<std::vector<std::string>> bad = {
      {"--sweep", "nothing"},
      {"--collider", "nobody"},
      {"--cases", "0"},
      {"--cases", "x"},
      {"--frames", "-1"},
      {"--jobs", "0"},
      {"--baseline", other},
      {"--baseline", no_json},
      {"--baseline", stored, "--seed", "7"},
      {"--baseline", "/nowhere"},
      {"--collider-command", " "},
      {"--json", "/dev/null/a.json"},
      {"--pictures", "/dev/null/x"},
      {"--pictures", folder.path().string(), "--json", (folder.path() / "touch.svg").string(),
       "--sweep", "touch"}};
  for (const auto& arguments : bad) {
    std::vector<std::string> all{"stress", "--cases",    "10",  "--sweep",
                                 "touch",  "--collider", "clip"};
    if (arguments[0] == "--cases") all = {"stress", "--sweep", "touch", "--collider", "clip"};
    if (arguments.size() > 2) {
      all = {"stress", "--cases", "100", "--frames", "300", "--collider", "clip"};
    }
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Outcome outcome = run_manifuzz(all);
    INFO(arguments[0] << ' ' << arguments[1] << ": " << outcome.err);
    CHECK(outcome.status == 2);
    CHECK(is_one_clear_line(outcome.err));
  }
}
