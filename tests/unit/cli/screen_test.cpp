#include <algorithm>
#include <string>

#include <catch2/catch.hpp>

#include "unit/cli/one_eyed.hpp"

using namespace manifuzz;
using namespace manifuzz::test;
using Catch::Contains;

namespace {

constexpr std::size_t kScreenLinesMost = 24;

/// A short campaign of every regime, which saves its findings in the folder.
Outcome screen_of(const TemporaryFolder& folder, const std::vector<std::string>& more) {
  return run_manifuzz(with({"fuzz", "--seed", "1", "--cases", "6000", "--shrink-seconds", "0",
                            "--corpus", corpus_in(folder)},
                           more));
}

std::string line_with(const Outcome& outcome, const std::string& part) {
  const auto lines = lines_of(outcome.out);
  const auto found = std::ranges::find_if(
      lines, [&](const std::string& line) { return line.find(part) != std::string::npos; });
  INFO(outcome.out);
  REQUIRE(found != lines.end());
  return *found;
}

}  // namespace

TEST_CASE("a campaign ends with a screen that says who is wrong in how many cases, and why") {
  const TemporaryFolder folder;
  const Outcome outcome = screen_of(folder, {});
  CHECK(outcome.status == 0);
  CHECK(lines_of(outcome.out).size() <= kScreenLinesMost);
  CHECK_THAT(outcome.out, Contains("clip against box2d 2.4.1: 6000 cases in"));
  CHECK_THAT(outcome.out, Contains("clip: no wrong answer\n"));
  CHECK_THAT(line_with(outcome, "box2d: wrong in "), Contains(" explained by the ledger"));
  CHECK_THAT(outcome.out, Contains("nothing that is new or unexplained"));
}

TEST_CASE("however much is wrong, a screen has at most 24 lines, and --verbose has the tables") {
  const TemporaryFolder folder;
  for (const auto& colliders :
       {std::vector<std::string>{"--subject", "box2d", "--oracle", "clip64"},
        std::vector<std::string>{"--subject", "chipmunk", "--oracle", "box2d"}}) {
    const Outcome outcome = screen_of(folder, with(colliders, {"--no-save"}));
    CHECK(outcome.status == 1);
    CHECK(lines_of(outcome.out).size() <= kScreenLinesMost);
    const Outcome verbose = screen_of(folder, with(colliders, {"--no-save", "--verbose"}));
    CHECK(lines_of(verbose.out).size() > kScreenLinesMost);
    CHECK_THAT(verbose.out, Contains("tied_faces  ") && Contains("new subject/subject_wrong/"));
  }
}

TEST_CASE("buckets of one kind are one finding on the screen, whose clearest case is shown") {
  const TemporaryFolder folder;
  const Outcome outcome = screen_of(folder, {"--subject-command", one_eyed(folder)});
  CHECK(outcome.status == 1);
  const auto lines = lines_of(outcome.out);
  CHECK(lines.size() <= kScreenLinesMost);
  CHECK(std::ranges::count_if(lines, [](const std::string& line) {
          return line.starts_with("new one_eyed: missed contact, ");
        }) == 1);
  CHECK_THAT(line_with(outcome, "new one_eyed: missed contact"), Contains(" buckets, by "));
  const std::string command = line_with(outcome, " show ");
  CHECK_THAT(command, Contains("missed_contact-none-b-gross"));
  const Outcome shown = run_program({"sh", "-c", command});
  INFO(shown.err);
  CHECK(shown.status == 0);
  CHECK_THAT(shown.out, Contains("one_eyed reports no contact"));
}

TEST_CASE("findings that are not saved are shown by the command that repeats them") {
  const TemporaryFolder folder;
  const Outcome outcome = screen_of(
      folder, {"--subject", "box2d", "--oracle", "clip64", "--no-save", "--regime", "sliver"});
  CHECK_THAT(line_with(outcome, "--first "), Contains(" fuzz --subject box2d --oracle clip64"));
}

TEST_CASE("a screen counts what is new, worse and gone against a baseline in a line") {
  const TemporaryFolder folder;
  const std::string json = (folder.path() / "before.json").string();
  const std::vector<std::string> box2d{"--subject", "box2d", "--oracle", "clip64", "--no-save"};
  screen_of(folder, with(box2d, {"--json", json}));
  const Outcome outcome = screen_of(folder, with(box2d, {"--baseline", json}));
  CHECK_THAT(outcome.out, Contains("buckets against the baseline: 0 new, 0 worse, "));
  CHECK(lines_of(outcome.out).size() <= kScreenLinesMost);
}

TEST_CASE("properties end with at most 20 lines, and one that applied to nothing is not OK",
          "[longer]") {
  const TemporaryFolder folder;
  const std::vector<std::string> words{
      "property", "--subject-command", one_eyed(folder), "--cases", "30", "--seed",
      "1",        "--corpus",          corpus_in(folder)};
  const Outcome outcome = run_manifuzz(words);
  INFO(outcome.err);
  CHECK(outcome.status == 1);
  CHECK(lines_of(outcome.out).size() <= 20);
  CHECK_THAT(outcome.out, Contains("one_eyed: ") && Contains(" properties hold") &&
                              Contains("FAIL never-empty: "));
  const Outcome verbose = run_manifuzz(with(words, {"--verbose", "--no-save"}));
  CHECK(lines_of(verbose.out).size() > 20);
  const Outcome vacuous = run_manifuzz(
      {"property", "--subject", "clip", "--cases", "1", "--seed", "1", "--no-save", "--verbose"});
  CHECK_THAT(vacuous.out, !Contains("OK, passed 1 tests") || Contains("ok  "));
}
