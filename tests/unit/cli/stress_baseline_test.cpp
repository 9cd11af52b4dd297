#include <algorithm>
#include <filesystem>
#include <iterator>
#include <sstream>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/interruption.hpp"
#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"
#include "unit/cli/stress_runs.hpp"

using namespace manifuzz::test;
using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

namespace {

/// As --store writes it after few cases, with these breaking points of `distance`.
Json baseline_of(const Json& points) {
  return {{"format", "manifuzz/breaking_points/1"},
          {"seed", 1},
          {"cases", 100},
          {"frames", 300},
          {"flush_to_zero", false},
          {"sweeps", {{"distance", points}}},
          {"walks", {{"sliding", {{"clip", 0}}}}}};
}

}  // namespace

TEST_CASE("a breaking point below the stored one is status 1, and named") {
  const TemporaryFolder folder;
  const std::string stored = (folder.path() / "stored.json").string();
  REQUIRE(run_small({"--store", stored}).status == 0);
  CHECK(run_small({"--baseline", stored}).status == 0);
  Json points = Json::parse(text_of(stored));
  points["sweeps"]["distance"]["box2d"] = nullptr;
  const Outcome worse = run_small({"--baseline", folder.write("better.json", points.dump())});
  CHECK(worse.status == 1);
  CHECK(worse.out.find("distance: box2d breaks at") != std::string::npos);
  points["sweeps"]["distance"]["box2d"] = 1;
  CHECK(run_small({"--baseline", folder.write("worse.json", points.dump())}).status == 0);
}

TEST_CASE("what is worse than stored is in the JSON, and said on stderr") {
  const TemporaryFolder folder;
  const std::string stored = folder.write("stored.json", baseline_of({{"box2d", nullptr}}).dump());
  const Outcome outcome = run_distance({"--baseline", stored, "--json", "-"});
  CHECK(outcome.status == 1);
  CHECK(outcome.err.find("distance: box2d breaks at") != std::string::npos);
  CHECK(Json::parse(outcome.out).at("worse").size() == 1);
}

TEST_CASE("a baseline that is damaged, or of another run, is refused before anything is run") {
  const TemporaryFolder folder;
  const Json good = baseline_of({{"box2d", 1.0}});
  const auto with = [&](const char* pointer, const Json& value) {
    Json changed = good;
    changed[Json::json_pointer(pointer)] = value;
    return changed;
  };
  const auto refuses = [&](const Json& baseline, const std::string& named) {
    const Outcome outcome =
        run_small({"--baseline", folder.write("baseline.json", baseline.dump())});
    INFO(baseline.dump() << ": " << outcome.err);
    CHECK(outcome.status == 2);
    CHECK(is_one_clear_line(outcome.err));
    CHECK(outcome.err.find(named) != std::string::npos);
    CHECK(outcome.out.empty());
  };
  CHECK(run_distance({"--baseline", folder.write("good.json", good.dump())}).status == 0);
  refuses(with("/sweeps/distance/box2d", 12345), "distance, box2d");
  refuses(with("/sweeps/distance/box2d", "never"), "distance, box2d");
  refuses(with("/walks/sliding/clip", nullptr), "sliding, clip");
  refuses(with("/walks/sliding/clip", -1), "sliding, clip");
  refuses(with("/sweeps", Json::array()), "sweeps");
  refuses(with("/sweeps/distance", 1), "distance");
  refuses(with("/sweeps/distance", Json::object())
              .patch(Json::parse(R"([{"op": "remove", "path": "/walks/sliding"}])")),
          "nothing");
  refuses(with("/flush_to_zero", true), "flush_to_zero");
  refuses(with("/cases", 7), "cases");
  const Outcome frames =
      run_distance({"--baseline", folder.write("frames.json", with("/frames", 7).dump())});
  CHECK(frames.status == 0);  // no walk is compared
}

TEST_CASE("what is stored of one sweep is added to what is there, on the same terms") {
  const TemporaryFolder folder;
  const std::string stored = (folder.path() / "stored.json").string();
  REQUIRE(run_small({"--store", stored}).status == 0);
  const Json whole = Json::parse(text_of(stored));
  Json points = whole;
  points["sweeps"]["distance"]["box2d"] = nullptr;
  folder.write("stored.json", points.dump());
  REQUIRE(run_distance({"--store", stored}).status == 0);
  CHECK(Json::parse(text_of(stored)) == whole);
  const Outcome other = run_distance({"--store", stored, "--seed", "7"});
  CHECK(other.status == 2);
  CHECK(is_one_clear_line(other.err));
  CHECK(run_distance({"--store", folder.write("notes.txt", "my notes")}).status == 2);
  CHECK(text_of(folder.path() / "notes.txt") == "my notes");
  CHECK(Json::parse(text_of(stored)) == whole);
}
