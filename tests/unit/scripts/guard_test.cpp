#include <cstdlib>
#include <filesystem>
#include <string>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/run_program.hpp"
#include "support/source_tree.hpp"
#include "support/temporary_folder.hpp"

// scripts/guard over stand-ins for valgrind and for what it counts.

using namespace manifuzz::test;
using Catch::Contains;
using Json = nlohmann::json;

namespace {

/// What the stand-in counts of everything.
constexpr int kCounted = 1000;

Json stored(int clip, int others = kCounted) {
  return {{"build", "a build"},
          {"target", "a target"},
          {"instructions",
           {{"clip", clip},
            {"pair", others},
            {"batch packed", others},
            {"batch indices", others},
            {"batch+hint indices", others},
            {"campaign cases", others}}}};
}

struct GuardRun {
  Outcome outcome;
  Json counts;  ///< as stored afterwards
};

GuardRun guard(const Json& counts, const std::vector<std::string>& options = {}) {
  const TemporaryFolder folder;
  const auto program = [&](const std::string& name, const std::string& body) {
    std::string path = folder.write(name, "#!/bin/sh\n" + body);
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    return path;
  };
  const std::string counter = program("counter", "echo a build\n");
  program("valgrind",
          "echo a target\necho '==7== Collected : " + std::to_string(kCounted) + "' >&2\n");
  const std::string file = folder.write("counts.json", counts.dump());
  const std::vector<std::string> command{
      "env", "MANIFUZZ_COUNTER=" + counter, "MANIFUZZ_COUNTS=" + file,
      "PATH=" + folder.path().string() + ":" + std::getenv("PATH"),
      (source_dir() / "scripts/guard").string()};
  const Outcome outcome = run_program(with(command, options));
  return {outcome, Json::parse(text_of(file))};
}

}  // namespace

TEST_CASE("counts within 3% of the stored ones pass") {
  for (const int clip : {kCounted, 971, 1030}) CHECK(guard(stored(clip)).outcome.status == 0);
}

TEST_CASE("a count that rose or fell by more than 3% fails, and says how to update") {
  for (const int clip : {970, 1031}) {
    const Outcome outcome = guard(stored(clip)).outcome;
    CHECK(outcome.status == 1);
    CHECK_THAT(outcome.out, Contains("clip: stored " + std::to_string(clip) + ", counted 1000, "));
    CHECK_THAT(outcome.out, Contains("scripts/guard --update"));
  }
  CHECK_THAT(guard(stored(970)).outcome.out, Contains("+3.09%"));
  CHECK_THAT(guard(stored(1031)).outcome.out, Contains("-3.01%"));
  CHECK(guard(stored(kCounted, 970)).outcome.status == 1);
}

TEST_CASE("an update stores what is counted") {
  const GuardRun run = guard(stored(1), {"--update"});
  CHECK(run.outcome.status == 0);
  CHECK(run.counts == stored(kCounted));
}

TEST_CASE("counts of another build or target are not checked, and it says so") {
  for (const char* key : {"build", "target"}) {
    Json counts = stored(1);
    counts[key] = "another";
    const Outcome outcome = guard(counts).outcome;
    CHECK(outcome.status == 0);
    CHECK_THAT(outcome.out, Contains("scripts/guard: skipped: the stored counts are for "));
  }
}

TEST_CASE("without valgrind nothing is checked, and it says so") {
  const TemporaryFolder folder;
  for (const char* const tool : {"bash", "dirname", "realpath"}) {
    std::filesystem::create_symlink(std::filesystem::path("/usr/bin") / tool, folder.path() / tool);
  }
  const Outcome outcome = run_program(
      {"env", "PATH=" + folder.path().string(), (source_dir() / "scripts/guard").string()});
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.out, Contains("scripts/guard: skipped: valgrind is missing"));
}

TEST_CASE("the guard refuses other options and counts that are not there") {
  for (const auto& options :
       std::vector<std::vector<std::string>>{{"--check"}, {"--update", "1"}}) {
    const Outcome outcome = guard(stored(kCounted), options).outcome;
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.err, Contains("takes no option but --update"));
  }
  CHECK(guard(Json::object()).outcome.status == 2);
  Json counts = stored(kCounted);
  counts["instructions"].erase("batch packed");
  CHECK(guard(counts).outcome.status == 2);
}
