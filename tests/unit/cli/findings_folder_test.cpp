#include <filesystem>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "base/file.hpp"
#include "corpus/corpus.hpp"
#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

using namespace manifuzz::test;
using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

namespace {

/// A campaign with known deviations of Box2D's and one kind of them in the corpus, run in a folder.
Json fuzz_in(const fs::path& folder, const fs::path& program,
             const std::vector<std::string>& more = {}) {
  std::vector<std::string> command{"sh",
                                   "-c",
                                   "cd \"$0\" && exec \"$@\" 2>/dev/null",
                                   folder.string(),
                                   program.string(),
                                   "fuzz",
                                   "--seed",
                                   "2",
                                   "--cases",
                                   "20000",
                                   "--regime",
                                   "tie_bias",
                                   "--radius",
                                   "0",
                                   "--json",
                                   "-"};
  const Outcome outcome = run_program(with(command, more));
  INFO(outcome.out);
  Json json = Json::parse(outcome.out, nullptr, false);
  REQUIRE(json.is_object());
  return json;
}

/// A tree with this program in its build.
fs::path program_in(const fs::path& tree) {
  const fs::path program = tree / "build" / "release" / "manifuzz";
  fs::create_directories(program.parent_path());
  fs::copy_file(manifuzz_path(), program);
  return program;
}

std::size_t cases_in(const fs::path& folder) {
  return manifuzz::read_corpus_folder(folder).cases.size();
}

}  // namespace

TEST_CASE("findings go to `found` where the program was built elsewhere, and are known from then") {
  const TemporaryFolder folder;
  for (const Json& bucket : fuzz_in(folder.path(), manifuzz_path())["buckets"]) {
    CHECK(bucket["new"] == true);
    CHECK(bucket["file"].get<std::string>().starts_with("found/defects/box2d/"));
  }
  const std::size_t saved = cases_in(folder.path() / "found");
  CHECK(saved > 0);
  CHECK_FALSE(fs::exists(folder.path() / "corpus"));
  for (const Json& bucket : fuzz_in(folder.path(), manifuzz_path())["buckets"]) {
    CHECK(bucket["new"] == false);
  }
  CHECK(cases_in(folder.path() / "found") == saved);
}

TEST_CASE("findings go to build/found of the tree that the program was built in, from all of it") {
  const TemporaryFolder folder;
  const fs::path program = program_in(folder.path());
  fs::create_directory(folder.path() / "below");
  fuzz_in(folder.path() / "below", program);
  CHECK(cases_in(folder.path() / "build" / "found") > 0);
  CHECK(fs::is_empty(folder.path() / "below"));
  const TemporaryFolder elsewhere;
  fuzz_in(elsewhere.path(), program);
  CHECK(fs::exists(elsewhere.path() / "found"));
}

TEST_CASE("what a campaign left is not drawn from: the regime corpus gives the same cases again") {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "corpus");
  const auto run = [&] {
    Json json = fuzz_in(folder.path(), manifuzz_path(), {"--regime", "corpus"});
    return std::pair(json["verdicts"], json["regimes"]);
  };
  const fs::path seeds = fs::path(MANIFUZZ_SOURCE_DIR) / "corpus" / "seeds";
  fs::copy(seeds, folder.path() / "corpus" / "seeds", fs::copy_options::recursive);
  const auto before = run();
  CHECK(cases_in(folder.path() / "found") > 0);
  CHECK(run() == before);
}

TEST_CASE("a bucket is looked up among findings too") {
  const TemporaryFolder folder;
  const Json json = fuzz_in(folder.path(), manifuzz_path());
  REQUIRE_FALSE(json["buckets"].empty());
  const Outcome shown =
      run_program({"sh", "-c", "cd \"$0\" && \"$1\" show \"$2\" 2>&1", folder.path().string(),
                   manifuzz_path(), json["buckets"][0]["bucket"].get<std::string>()});
  CHECK(shown.status == 0);
  CHECK(shown.out.find("using found/defects/box2d/") != std::string::npos);
}

TEST_CASE("a file in the place of the folder for findings is what the error names") {
  const TemporaryFolder folder;
  manifuzz::write_file((folder.path() / "found").string(), "");
  for (const char* const command : {"fuzz", "property", "smoke"}) {
    const Outcome outcome = run_program(
        {"sh", "-c", "cd \"$0\" && exec \"$@\"", folder.path().string(), manifuzz_path(), command});
    CAPTURE(command, outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.err == "manifuzz: findings: found: is no folder\n");
  }
}
