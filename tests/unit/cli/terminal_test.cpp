// What a terminal shows and a pipe does not: colours and progress. What --quiet leaves.

#include <filesystem>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

using namespace manifuzz::test;
using Catch::Contains;

namespace {

const std::string kDefects = MANIFUZZ_SOURCE_DIR "/corpus/defects/box2d";

const std::string kRed = "\x1b[31m";
const std::string kYellow = "\x1b[33m";
const std::string kErased = "\r\x1b[K";

/// A campaign in which Box2D is at fault.
std::vector<std::string> box2d_campaign(const TemporaryFolder& folder,
                                        const std::vector<std::string>& more,
                                        const char* cases = "5000") {
  const std::vector<std::string> words{
      manifuzz_path(), "fuzz", "--subject", "box2d",
      "--oracle",      "clip", "--regime",  "tie_bias",
      "--seed",        "1",    "--cases",   cases,
      "--jobs",        "1",    "--corpus",  (folder.path() / "corpus").string()};
  return with(words, more);
}

/// What it shows on a terminal in that environment.
std::string shown(const std::vector<std::string>& environment,
                  const std::vector<std::string>& command) {
  return run_on_terminal(with(with({"env", "-u", "NO_COLOR"}, environment), command)).out;
}

bool has_colour(const std::string& text) {
  return text.find("\x1b[3") != std::string::npos;
}

}  // namespace

TEST_CASE("a terminal shows what decides the status in red, what is new in yellow") {
  const TemporaryFolder folder;
  const std::string screen = shown({"TERM=xterm"}, box2d_campaign(folder, {"--no-save"}));
  CHECK_THAT(screen, Contains(kYellow + "new "));
  CHECK_THAT(screen, Contains(kRed + "box2d: missed contact"));
  const std::string text =
      shown({"TERM=xterm"}, box2d_campaign(folder, {"--no-save", "--verbose"}));
  CHECK_THAT(text, Contains(kYellow + "new "));
  CHECK_THAT(text, Contains(kRed + "subject/subject_wrong/missed_contact"));
  CHECK_THAT(text, Contains(kRed + "subject_wrong "));
  CHECK_THAT(shown({"TERM=xterm"}, {manifuzz_path(), "fuz"}),
             Contains(kRed + "manifuzz:\x1b[0m there is no command 'fuz'"));
}

TEST_CASE("without its colours the text is what a pipe gets") {
  const std::vector<std::string> command{manifuzz_path(), "replay", kDefects,   "--quiet",
                                         "--subject",     "box2d",  "--oracle", "clip"};
  const std::string piped = run_program(command).out;
  REQUIRE(piped.starts_with("FAIL "));
  std::string text = shown({"TERM=xterm"}, command);
  REQUIRE(has_colour(text));
  for (const std::string& mark : {kRed, std::string("\x1b[0m"), std::string("\r")}) {
    for (std::size_t at = 0; (at = text.find(mark, at)) != std::string::npos;) {
      text.erase(at, mark.size());
    }
  }
  CHECK(text == piped);
}

TEST_CASE("nothing is coloured where it is not wanted, or no terminal shows it") {
  const TemporaryFolder folder;
  const auto all = box2d_campaign(folder, {"--no-save"});
  CHECK_FALSE(has_colour(run_program(all).out));
  CHECK_FALSE(has_colour(shown({"TERM=dumb"}, all)));
  CHECK_FALSE(has_colour(shown({"-u", "TERM"}, all)));
  CHECK_FALSE(has_colour(shown({"TERM=xterm", "NO_COLOR=1"}, all)));
  CHECK(has_colour(shown({"TERM=xterm", "NO_COLOR="}, all)));
  CHECK_FALSE(
      has_colour(shown({"TERM=xterm"}, box2d_campaign(folder, {"--no-save", "--no-color"}))));
  CHECK_FALSE(has_colour(shown({"TERM=xterm"}, {manifuzz_path(), "--no-color", "fuz"})));
  CHECK_FALSE(has_colour(shown({"TERM=xterm"}, {manifuzz_path(), "fuzz", "--sed", "--no-color"})));
}

TEST_CASE("each stream is coloured for itself") {
  const std::string text = shown(
      {"TERM=xterm"}, {"sh", "-c",
                       "\"$0\" property depth-is-overlap --cases 10 --seed 1 --no-save --verbose "
                       "| cat; "
                       "\"$0\" fuz",
                       manifuzz_path()});
  CHECK_THAT(text, Contains("ok   depth-is-overlap"));  // no colour between the words
  CHECK_THAT(text, Contains(kRed + "manifuzz:"));
}

TEST_CASE("progress is for terminals, and not for quiet ones") {
  const TemporaryFolder folder;
  CHECK_THAT(shown({"TERM=xterm"}, box2d_campaign(folder, {}, "100")),
             Contains("\rshrinking ") && Contains(kErased));
  const TemporaryFolder another;
  const Outcome piped = run_program(box2d_campaign(another, {}, "100"));
  CHECK(piped.err.empty());
  CHECK(piped.out.find('\r') == std::string::npos);
  for (const char* terminal : {"TERM=xterm", "TERM=dumb"}) {
    const TemporaryFolder third;
    const bool is_able = terminal == std::string("TERM=xterm");
    const auto command = box2d_campaign(
        third, is_able ? std::vector<std::string>{"--quiet"} : std::vector<std::string>{});
    CHECK(shown({terminal}, command).find(kErased) == std::string::npos);
  }
}

TEST_CASE("a quiet campaign says what decides its status, where a file has the rest") {
  const TemporaryFolder folder;
  const std::string json = (folder.path() / "summary.json").string();
  const Outcome loud =
      run_program(box2d_campaign(folder, {"--no-save", "--verbose", "--json", json}));
  CHECK_THAT(loud.out, Contains("box2d against clip"));
  CHECK_THAT(run_program(box2d_campaign(folder, {"--no-save", "--quiet"})).out,
             Contains("box2d against clip"));
  const Outcome quiet =
      run_program(box2d_campaign(folder, {"--no-save", "--quiet", "--json", json}));
  CHECK(quiet.status == 1);
  CHECK(quiet.err.empty());
  CHECK(quiet.out.starts_with("new subject/"));
  for (const std::string& line : lines_of(quiet.out)) {
    CAPTURE(line);
    CHECK((line.starts_with("new subject/") || line.starts_with("  ")));  // how to see it
    CHECK_THAT(loud.out, Contains(line));
  }
  const std::vector<std::string> harmless{
      "--quiet", "fuzz", "--regime", "separated", "--seed",   "1",
      "--cases", "10",   "--json",   json,        "--corpus", (folder.path() / "corpus").string()};
  const Outcome silent = run_manifuzz(harmless);
  CHECK(silent.status == 0);
  CHECK((silent.out + silent.err).empty());
}

TEST_CASE("a quiet replay, property or smoke run names failures alone") {
  const std::vector<std::string> replay{"replay", MANIFUZZ_SOURCE_DIR "/corpus/seeds"};
  CHECK(run_manifuzz(replay).out.find("passed") != std::string::npos);
  const Outcome quiet = run_manifuzz({"--quiet", replay[0], replay[1]});
  CHECK(quiet.status == 0);
  CHECK((quiet.out + quiet.err).empty());
  const Outcome wrong =
      run_manifuzz({"replay", kDefects, "--subject", "box2d", "--oracle", "clip", "--quiet"});
  CHECK(wrong.status == 1);
  CHECK(wrong.out.starts_with("FAIL "));
  for (const std::string& line : lines_of(wrong.out)) CHECK(line.starts_with("FAIL "));
  const Outcome property = run_manifuzz(
      {"property", "depth-is-overlap", "--quiet", "--cases", "10", "--seed", "1", "--no-save"});
  CHECK(property.status == 0);
  CHECK((property.out + property.err).empty());
  const TemporaryFolder folder;
  const Outcome smoke =
      run_manifuzz({"smoke", "--quiet", "--oracle", "clip64", "--seed", "1", "--seconds", "2",
                    "--no-save", "--corpus", (folder.path() / "corpus").string()});
  CHECK(smoke.status == 0);
  CHECK((smoke.out + smoke.err).empty());
}

TEST_CASE("quiet or not, data stays and errors stay") {
  const std::vector<std::string> cases{"generate", "--seed", "1", "--cases", "3"};
  CHECK(run_manifuzz({cases[0], cases[1], cases[2], cases[3], cases[4], "--quiet"}).out ==
        run_manifuzz(cases).out);
  const Outcome wrong = run_manifuzz({"--quiet", "generate", "--regime", "genric"});
  CHECK(wrong.status == 2);
  CHECK(is_one_clear_line(wrong.err));
}
