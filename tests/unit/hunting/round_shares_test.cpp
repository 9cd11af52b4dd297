#include <algorithm>
#include <filesystem>

#include <catch2/catch.hpp>

#include "unit/cli/merge_runs.hpp"

using namespace manifuzz::test;
using Catch::Contains;

namespace {

using Words = std::vector<std::string>;

const Words kHunt{"hunt",       "--subject=box2d", "--seed=3", "--cases=2400",
                  "--radius=0", "--rounds=2",      "--jobs=1", "--shrink-seconds=1"};

/// A share of a round, with its result in NAME.json and its findings in NAME.
Outcome hunt(const TemporaryFolder& folder, const std::string& name, const Words& more) {
  const std::string path = (folder.path() / name).string();
  const Words where{"--corpus=nothing", "--found=" + path, "--json=" + path + ".json",
                    "--archives=" + (folder.path() / "archives").string()};
  return run_manifuzz(with(with(kHunt, where), more));
}

/// The results of two rounds of two shares.
Words run_all(const TemporaryFolder& folder) {
  Words names;
  for (const char* const round : {"0", "1"}) {
    for (const char* const share : {"1", "0"}) {
      const std::string name = std::string("r") + round + share;
      const Outcome outcome =
          hunt(folder, name, {"--round", round, "--share", share + std::string("/2")});
      CAPTURE(outcome.err);
      REQUIRE(outcome.status == 1);
      names.insert(names.end(), {name, name + ".json"});
    }
  }
  return names;
}

}  // namespace

TEST_CASE("shares of a hunt, merged, are the hunt: its cases, its cells, its worst cases",
          "[longer]") {
  const TemporaryFolder folder;
  const Words names = run_all(folder);
  const Words archives{"--archives=" + (folder.path() / "archives").string()};
  const Outcome outcome = merge(folder, names, "all", archives);
  CAPTURE(outcome.err);
  REQUIRE(outcome.status == 0);
  const Json all = Json::parse(text_of(folder.path() / "all.json"));
  CHECK(all["cases"] == 2400);
  CHECK_FALSE(all.contains("parts"));
  CHECK(all["failed"] == true);
  std::uint64_t generations = 0;
  for (const char* const name : {"r00", "r01", "r10", "r11"}) {
    const Json share = Json::parse(text_of(folder.path() / (std::string(name) + ".json")));
    generations += share["generations"].get<std::uint64_t>();
    CHECK(share["cells"] < all["cells"]);
    for (std::size_t i = 0; i < share["rows"].size(); ++i) {
      CHECK(share["rows"][i]["worst"] <= all["rows"][i]["worst"]);
    }
  }
  CHECK(all["generations"] == generations);
  for (const Json& row : all["rows"]) {
    if (row["worst"] == 0) continue;
    const Json known = Json::parse(text_of(row["file"].get<std::string>()));
    CHECK(known["found"]["index"] == row["index"]);
  }
  for (const Json& bucket : all["buckets"]) {
    if (bucket["new"]) CHECK(std::filesystem::exists(bucket["file"].get<std::string>()));
  }
  const Outcome some = merge(folder, {names.begin(), names.end() - 2}, "some", archives);
  CHECK(some.status == 2);
  CHECK_THAT(some.err, Contains("are of 1800 of the hunt's 2400 cases"));
  Json dealt_to_nobody = Json::parse(text_of(folder.path() / "r00.json"));
  dealt_to_nobody["shares"] = 0;
  folder.write("nobody.json", dealt_to_nobody.dump());
  CHECK_THAT(merge(folder, {"nobody.json"}, "none").err, Contains("nobody.json: $.shares: is 0"));
  std::filesystem::remove(folder.path() / "archives" / "round-1-share-0.archive");
  const Outcome incomplete = merge(folder, names, "again", archives);
  CHECK(incomplete.status == 2);
  CHECK_THAT(incomplete.err, Contains("round-1-share-0.archive is not there"));
  CHECK_FALSE(std::filesystem::exists(folder.path() / "again"));
}

TEST_CASE("what is no share of a round is one line, and writes nothing") {
  const TemporaryFolder folder;
  const std::vector<std::pair<Words, std::string>> wrong{
      {{"--share=2/2", "--round=0"}, "'2/2' is no share"},
      {{"--share=0/2", "--round=2"}, "--round: 2 is no round of 2"},
      {{"--share=0/2"}, "--share requires --round"},
      {{"--round=0"}, "requires --share"},
      {{"--share=0/2", "--round=1"}, "round-0-share-0.archive is not there"},
      {{"--share=0/1201", "--round=0"}, "too many shares of 2400 cases; use at most 1200"}};
  for (const auto& [options, text] : wrong) {
    CAPTURE(options);
    const Outcome outcome = hunt(folder, "none", options);
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.err, Contains(text));
    CHECK(std::ranges::count(outcome.err, '\n') == 1);
  }
  CHECK(std::filesystem::is_empty(folder.path()));
}
