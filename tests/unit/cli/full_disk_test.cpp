#include <algorithm>
#include <filesystem>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "corpus/corpus.hpp"
#include "support/bad_cases.hpp"
#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"
#include "unit/report/svg_reader.hpp"

// An output whose disk is full is one clear line and status 2, and costs no other output anything.

using namespace manifuzz::test;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

const std::string kFull = "/dev/full";
const std::string kComplaint = "manifuzz: /dev/full: cannot write it: No space left on device\n";

/// A campaign in which Box2D is at fault, and its findings are saved.
std::vector<std::string> faulty_campaign(const TemporaryFolder& folder) {
  return {"fuzz",
          "--subject",
          "box2d",
          "--oracle",
          "clip",
          "--regime",
          "tie_bias",
          "--seed",
          "1",
          "--cases",
          "2000",
          "--jobs",
          "1",
          "--shrink-seconds",
          "0",
          "--corpus",
          (folder.path() / "corpus").string()};
}

std::size_t saved_in(const TemporaryFolder& folder) {
  return manifuzz::read_corpus_folder(folder.path() / "corpus").cases.size();
}

}  // namespace

TEST_CASE("a full disk for one output of a campaign costs neither its findings nor the others") {
  const TemporaryFolder plain;
  REQUIRE(run_manifuzz(faulty_campaign(plain)).status == 1);
  const std::size_t saved = saved_in(plain);
  REQUIRE(saved > 0);
  for (const std::string full : {"--json", "--junit"}) {
    const TemporaryFolder folder;
    const std::string other = full == "--json" ? "--junit" : "--json";
    const std::string written = (folder.path() / "written").string();
    const Outcome outcome =
        run_manifuzz(with(faulty_campaign(folder), {full, kFull, other, written}));
    CAPTURE(full, outcome.out);
    CHECK(outcome.status == 2);
    CHECK(outcome.err == kComplaint);
    CHECK_THAT(outcome.out, Contains("new box2d: missed contact"));
    CHECK(saved_in(folder) == saved);
    if (other == "--json") CHECK(nlohmann::json::parse(text_of(written))["cases"] == 2000);
    if (other == "--junit") CHECK(read_svg(text_of(written))[0].name == "testsuites");
  }
}

TEST_CASE("a full disk is one clear line and status 2 for every command's outputs") {
  const TemporaryFolder folder;
  const std::string good = folder.write("good.json", good_case());
  const std::string corpus = (folder.path() / "corpus").string();
  const std::string run = (folder.path() / "run.json").string();
  REQUIRE(run_manifuzz(with(faulty_campaign(folder), {"--json", run})).status == 1);
  const std::string merged = (folder.path() / "merged").string();
  const std::vector<std::vector<std::string>> commands{
      {"replay", good, "--json", kFull},
      {"replay", good, "--junit", kFull},
      {"property", "never-empty", "--cases", "10", "--seed", "1", "--no-save", "--corpus", corpus,
       "--junit", kFull},
      {"smoke", "--seconds", "0.01", "--seed", "1", "--no-save", "--corpus", corpus, "--junit",
       kFull},
      {"stress", "--quick", "--sweep", "distance", "--collider", "clip", "--cases", "10", "--json",
       kFull},
      {"scene", "--scene", "resting_pile", "--bodies", "10", "--steps", "1", "--json", kFull},
      {"merge", corpus, run, "--output", merged, "--json", kFull}};
  for (const auto& command : commands) {
    const Outcome outcome = run_manifuzz(command);
    CAPTURE(command, outcome.out, outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.err == kComplaint);
  }
}

TEST_CASE(
    "a standard output on a full disk is one clear line and status 2, and files are written") {
  const TemporaryFolder folder;
  const std::string json = (folder.path() / "run.json").string();
  auto command = with({"sh", "-c", "\"$@\" > /dev/full", "sh", manifuzz_path()},
                      with(faulty_campaign(folder), {"--json", json}));
  const Outcome outcome = run_program(command);
  CAPTURE(outcome.err);
  CHECK(outcome.status == 2);
  CHECK(is_one_clear_line(outcome.err));
  CHECK_THAT(outcome.err, Contains("stdout: cannot write it: No space left on device"));
  CHECK(saved_in(folder) > 0);
  CHECK(nlohmann::json::parse(text_of(json))["cases"] == 2000);
}
