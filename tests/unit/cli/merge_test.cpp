#include <algorithm>
#include <filesystem>
#include <map>

#include <catch2/catch.hpp>

#include "corpus/corpus.hpp"
#include "corpus/shrink.hpp"
#include "unit/cli/merge_runs.hpp"

using namespace manifuzz;
using namespace manifuzz::test;
namespace fs = std::filesystem;

namespace {

/// Every case below the folder by its bucket: of each the smallest, and the worst's text.
struct Kept {
  std::map<std::string, PairCase> smallest;
  std::map<std::string, std::string> worst;
};
Kept kept_in(const fs::path& folder) {
  Kept kept;
  for (const CorpusCase& known : read_corpus({&folder, 1}).cases) {
    if (known.path.ends_with(".worst.json")) {
      CHECK(kept.worst.emplace(known.expect->bucket, text_of(known.path)).second);
    } else {
      CHECK(kept.smallest.emplace(known.expect->bucket, known.pair()).second);
    }
  }
  return kept;
}

/// What must be the same, however the cases were dealt to runs.
Json counted(Json run) {
  for (const char* key : {"seconds", "cases_per_second", "jobs", "parts"}) run.erase(key);
  for (Json& bucket : run["buckets"]) {
    bucket.erase("file");
    bucket.erase("command");
  }
  return run;
}

}  // namespace

TEST_CASE("runs over disjoint indices, merged, count what one run counts", "[longer]") {
  const TemporaryFolder folder;
  const Json one = count(folder, "one", 0, 9000);
  run(folder, "p", 0, 3000);
  run(folder, "q", 1500, 2000);
  run(folder, "r", 2500, 4000);
  const Outcome outcome = merge(folder, {"r", "p", "q", "q.json", "p.json", "r.json"}, "all");
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  const Json all = Json::parse(text_of(folder.path() / "all.json"));
  CHECK(counted(all) == counted(one));
  REQUIRE(all["buckets"].size() >= 3);
  for (const Json& bucket : all["buckets"]) CHECK(fs::exists(bucket["file"].get<std::string>()));
}

TEST_CASE(
    "runs merged keep one run's worst witnesses byte for byte, and none of its smallest grows",
    "[longer]") {
  const TemporaryFolder folder;
  run(folder, "one", 0, 9000);
  run(folder, "p", 0, 3000);
  run(folder, "q", 1500, 6000);
  REQUIRE(merge(folder, {"p", "q"}, "all").status == 0);
  const Kept one = kept_in(folder.path() / "one");
  const Kept all = kept_in(folder.path() / "all");
  REQUIRE(one.worst.size() >= 3);
  CHECK(all.worst == one.worst);
  REQUIRE(all.smallest.size() == one.smallest.size());
  for (const auto& [bucket, pair] : one.smallest) {
    INFO(bucket);
    CHECK(simplicity(complexity(all.smallest.at(bucket))) <= simplicity(complexity(pair)));
  }
}

TEST_CASE("a run merged alone is the same folder again") {
  const TemporaryFolder folder;
  run(folder, "one", 0, 4000);
  REQUIRE(merge(folder, {"one"}, "again").status == 0);
  std::size_t files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder.path() / "one")) {
    if (!entry.is_regular_file()) continue;
    ++files;
    const fs::path again = folder.path() / "again" / fs::relative(entry, folder.path() / "one");
    INFO(again);
    CHECK(text_of(again) == text_of(entry.path()));
  }
  CHECK(files >= 4);
}

TEST_CASE("merging names broken files and results of other cases, and merges the rest") {
  const TemporaryFolder folder;
  run(folder, "p", 0, 2000);
  count(folder, "q", 500, 2000);  // overlaps
  count(folder, "r", 0, 2000, "3");
  folder.write("p/broken.json", "{");
  folder.write("s.json", R"({"machine": {}, "buckets": 7})");
  const Outcome outcome = merge(folder, {"p", "p.json", "q.json", "r.json", "s.json"}, "all");
  CHECK(outcome.status == 2);
  const std::vector<std::string> lines = lines_of(outcome.err);
  REQUIRE(lines.size() == 4);
  CHECK(lines[0].find("p/broken.json: ") != std::string::npos);
  CHECK(lines[2].find("q.json: counts cases of seed 2 from 500 on") != std::string::npos);
  CHECK(lines[1].find("s.json: $: the key \"compiler\" is missing") != std::string::npos);
  CHECK(lines[3].find("3 of the files") != std::string::npos);
  const Json all = Json::parse(text_of(folder.path() / "all.json"));
  CHECK(all["cases"] == 4000);
  CHECK(all["seed"].is_null());
  CHECK_FALSE(kept_in(folder.path() / "all").smallest.empty());
}

TEST_CASE("merging does not mix with what is there") {
  const TemporaryFolder folder;
  run(folder, "p", 0, 1000);
  fs::create_directories(folder.path() / "all");
  folder.write("all/mine.txt", "mine");
  const Outcome outcome = merge(folder, {"p"}, "all");
  CHECK(outcome.status == 2);
  CHECK(is_one_clear_line(outcome.err));
  CHECK(text_of(folder.path() / "all/mine.txt") == "mine");
}

TEST_CASE("a result of other versions is left out, whichever comes first") {
  const TemporaryFolder folder;
  for (const char* const name : {"q", "r"}) count(folder, name, *name == 'q' ? 0 : 500, 1000);
  Json other = Json::parse(text_of(folder.path() / "q.json"));
  other["versions"]["manifuzz"] = "9.9";
  folder.write("a.json", other.dump());
  const Outcome outcome = merge(folder, {"a.json", "q.json", "r.json"}, "all");
  CHECK(outcome.status == 2);
  REQUIRE(lines_of(outcome.err).size() == 2);
  CHECK(lines_of(outcome.err)[0].find("a.json: is of clip against box2d (manifuzz 9.9") !=
        std::string::npos);
  CHECK(Json::parse(text_of(folder.path() / "all.json"))["cases"] == 2000);
  CHECK_FALSE(fs::exists(folder.path() / "all"));
}

TEST_CASE("results of other settings are no overlap, and are not added up") {
  const TemporaryFolder folder;
  count(folder, "q", 0, 1000);
  count(folder, "r", 500, 1000);
  const Json other = Json::parse(text_of(folder.path() / "q.json"));
  for (const auto& [key, value] :
       {std::pair<const char*, Json>("radius", 0.5), {"tie_bias", 0.25}, {"judge_every", 3}}) {
    Json bad = other;
    bad[key] = value;
    folder.write("a.json", bad.dump());
    const Outcome outcome = merge(folder, {"a.json", "q.json", "r.json"}, "all");
    CAPTURE(key, outcome.err);
    CHECK(outcome.status == 2);
    CHECK(lines_of(outcome.err)[0].find("a.json: is of clip against box2d") != std::string::npos);
    CHECK(Json::parse(text_of(folder.path() / "all.json"))["cases"] == 2000);
  }
}

TEST_CASE("sums of sums are the sum, whatever the seeds and whatever came first") {
  const TemporaryFolder folder;
  for (const char* const seed : {"2", "3"}) {
    count(folder, std::string("a") + seed, 0, 1500, seed);
    count(folder, std::string("b") + seed, 750, 1500, seed);
  }
  const auto sum = [&](const std::vector<std::string>& names, const std::string& output) {
    REQUIRE(merge(folder, names, output).status == 0);
    return text_of(folder.path() / (output + ".json"));
  };
  const std::string all = sum({"a2.json", "a3.json", "b2.json", "b3.json"}, "all");
  sum({"b3.json", "a2.json"}, "x");
  sum({"b2.json", "a3.json"}, "y");
  CHECK(sum({"y.json", "x.json"}, "sums") == all);
  sum({"a2.json", "b2.json"}, "z");
  CHECK(sum({"b3.json", "z.json", "a3.json"}, "mixed") == all);
}

TEST_CASE("a bucket's first case keeps its seed through sums of sums") {
  const TemporaryFolder folder;
  for (const char* const seed : {"1", "5", "8"}) count(folder, seed, 0, 60, seed);
  REQUIRE(merge(folder, {"1.json", "8.json"}, "x").status == 0);
  REQUIRE(merge(folder, {"x.json", "5.json"}, "sums").status == 0);
  REQUIRE(merge(folder, {"5.json", "8.json", "1.json"}, "all").status == 0);
  CHECK(text_of(folder.path() / "sums.json") == text_of(folder.path() / "all.json"));
  const Json all = Json::parse(text_of(folder.path() / "all.json"));
  CHECK(all["buckets"].size() >= 3);
  for (const Json& bucket : all["buckets"]) {
    const std::string seed = " --seed " + bucket["seed"].dump() + " ";
    CHECK(bucket["command"].get<std::string>().find(seed) != std::string::npos);
  }
}

TEST_CASE("a file that is named twice is merged once") {
  const TemporaryFolder folder;
  run(folder, "p", 0, 500);
  fs::create_symlink(folder.path() / "p.json", folder.path() / "link.json");
  REQUIRE(merge(folder, {"p", "./p", "link.json", "./p.json", "p.json"}, "all").status == 0);
  CHECK(Json::parse(text_of(folder.path() / "all.json"))["cases"] == 500);
}
