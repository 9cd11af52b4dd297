#include <filesystem>
#include <fstream>
#include <iterator>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

using namespace manifuzz::test;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

/// Few cases of two sweeps and a walk, and what else is asked.
Outcome run_small(std::vector<std::string> more) {
  std::vector<std::string> all{"stress",  "--sweep",    "distance", "--sweep",    "collinear",
                               "--sweep", "sliding",    "--cases",  "100",        "--frames",
                               "300",     "--collider", "clip",     "--collider", "box2d"};
  all.insert(all.end(), more.begin(), more.end());
  return run_manifuzz(all);
}

std::string read(const fs::path& path) {
  std::ifstream stream(path);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

TEST_CASE("stress writes a table, JSON, CSV and pictures of what it measured") {
  const TemporaryFolder folder;
  const fs::path json = folder.path() / "stress.json";
  const fs::path csv = folder.path() / "stress.csv";
  const fs::path pictures = folder.path() / "pictures";
  const Outcome outcome =
      run_small({"--json", json.string(), "--csv", csv.string(), "--pictures", pictures.string()});
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  CHECK(outcome.out.find("distance") != std::string::npos);
  CHECK(outcome.out.find("never") != std::string::npos);
  const Json report = Json::parse(read(json));
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
  CHECK(read(csv).starts_with("sweep,collider,x,"));
  for (const char* name : {"distance.svg", "distance.png", "collinear.svg", "collinear.png"}) {
    CHECK(fs::file_size(pictures / name) > 1000);
  }
}

TEST_CASE("stress comes to the same whatever the jobs") {
  const auto figures = [](const char* jobs) {
    Json report = Json::parse(run_small({"--jobs", jobs, "--json", "-"}).out);
    report.erase("seconds");
    return report;
  };
  CHECK(figures("1") == figures("3"));
}

TEST_CASE("a breaking point below the stored one is status 1, and named") {
  const TemporaryFolder folder;
  const std::string stored = (folder.path() / "stored.json").string();
  REQUIRE(run_small({"--store", stored}).status == 0);
  CHECK(run_small({"--baseline", stored}).status == 0);
  Json points = Json::parse(read(stored));
  points["sweeps"]["distance"]["box2d"] = nullptr;
  const Outcome worse = run_small({"--baseline", folder.write("better.json", points.dump())});
  CHECK(worse.status == 1);
  CHECK(worse.out.find("distance: box2d breaks at") != std::string::npos);
  points["sweeps"]["distance"]["box2d"] = 1;
  CHECK(run_small({"--baseline", folder.write("worse.json", points.dump())}).status == 0);
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
  const Outcome replayed = run_manifuzz({"replay", corpus.string()});
  INFO(replayed.out);
  CHECK(replayed.status == 0);
}

TEST_CASE("an interrupted stress keeps what it measured") {
  const TemporaryFolder folder;
  const std::string json = (folder.path() / "stress.json").string();
  const Outcome outcome =
      run_program({"timeout", "--signal=INT", "3", manifuzz_path(), "stress", "--sweep", "touch",
                   "--collider", "clip", "--cases", "20000", "--sweep", "large", "--json", json});
  INFO(outcome.err);
  CHECK(outcome.status == 124);  // what timeout says of a program it had to signal
  CHECK(outcome.out.find("interrupted") != std::string::npos);
  CHECK(Json::parse(read(json)).at("interrupted") == true);
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
  const std::vector<std::vector<std::string>> bad = {{"--sweep", "nothing"},
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
                                                     {"--pictures", "/dev/null/x"}};
  for (const auto& arguments : bad) {
    std::vector<std::string> all{"stress", "--cases",    "10",  "--sweep",
                                 "touch",  "--collider", "clip"};
    if (arguments[0] == "--cases") all = {"stress", "--sweep", "touch", "--collider", "clip"};
    if (arguments.size() > 2) all = {"stress", "--cases", "100", "--frames", "300"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Outcome outcome = run_manifuzz(all);
    INFO(arguments[0] << ' ' << arguments[1] << ": " << outcome.err);
    CHECK(outcome.status == 2);
    CHECK(is_one_clear_line(outcome.err));
  }
}
