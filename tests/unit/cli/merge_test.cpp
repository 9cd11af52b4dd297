#include <filesystem>
#include <fstream>
#include <map>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cases/corpus.hpp"
#include "cases/simplicity.hpp"
#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

using namespace manifuzz;
using namespace manifuzz::test;
using Json = nlohmann::ordered_json;

namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A campaign over indices from `first` on, to NAME/ and NAME.json in the folder.
Json run(const TemporaryFolder& folder, const std::string& name, int first, int cases,
         const std::string& seed = "2") {
  const std::string corpus = (folder.path() / name).string();
  const Outcome outcome =
      run_manifuzz({"fuzz", "--regime", "tie_bias", "--regime", "sliver", "--radius", "0", "--seed",
                    seed, "--first", std::to_string(first), "--cases", std::to_string(cases),
                    "--corpus", corpus, "--json", corpus + ".json"});
  CHECK(outcome.status == 0);
  return Json::parse(text_of(corpus + ".json"));
}

Outcome merge(const TemporaryFolder& folder, const std::vector<std::string>& names,
              const std::string& output) {
  std::vector<std::string> arguments{"merge"};
  for (const std::string& name : names) arguments.push_back((folder.path() / name).string());
  const std::string all = (folder.path() / output).string();
  for (const std::string& more :
       {std::string("--output"), all, std::string("--json"), all + ".json"})
    arguments.push_back(more);
  return run_manifuzz(arguments);
}

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
      CHECK(kept.smallest.emplace(known.expect->bucket, known.pair).second);
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

TEST_CASE("runs over disjoint indices, merged, count what one run counts") {
  const TemporaryFolder folder;
  const Json one = run(folder, "one", 0, 9000);
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
    "runs merged keep one run's worst witnesses byte for byte, and none of its smallest grows") {
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
    CHECK(complexity(all.smallest.at(bucket)) <= complexity(pair));
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
  run(folder, "q", 500, 2000);  // overlaps
  run(folder, "r", 0, 2000, "3");
  folder.write("p/broken.json", "{");
  folder.write("s.json", R"({"machine": {}, "buckets": 7})");
  const Outcome outcome = merge(folder, {"p", "p.json", "q.json", "r.json", "s.json"}, "all");
  CHECK(outcome.status == 2);
  const std::vector<std::string> lines = lines_of(outcome.err);
  REQUIRE(lines.size() == 4);
  CHECK(lines[0].find("p/broken.json: ") != std::string::npos);
  CHECK(lines[2].find("q.json: counts cases of seed 2 from 500 on") != std::string::npos);
  CHECK(lines[1].find("s.json: what fuzz --json writes is expected") != std::string::npos);
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
