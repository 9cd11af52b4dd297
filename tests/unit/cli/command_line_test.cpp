#include <filesystem>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "cli/commands.hpp"
#include "support/bad_cases.hpp"
#include "support/named_tests.hpp"
#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

using namespace manifuzz::test;

namespace {

struct BadUsage {
  std::string name;
  std::vector<std::string> arguments;
  std::string complaint;
};

const std::vector<BadUsage>& bad_usages() {
  static const std::vector<BadUsage> all = {
      {"no command", {"--quiet"}, "a command is missing; try manifuzz --help"},
      {"an unknown command", {"colide"}, "there is no command 'colide'; did you mean 'collide'?"},
      {"a command like no other", {"xyzzy"}, "there is no command 'xyzzy'; there are fuzz,"},
      {"an unknown option before the command", {"--fast"}, "there is no option '--fast'"},
      {"an unknown option",
       {"generate", "--sed", "1"},
       "generate: there is no option '--sed'; did you mean '--seed'? Try manifuzz generate --help"},
      {"an unknown option with its value",
       {"generate", "--case=1"},
       "there is no option '--case'; did you mean '--cases'?"},
      {"an option like no other",
       {"generate", "--xyzzy"},
       "no option '--xyzzy'; try manifuzz generate --help"},
      {"a required option that is misspelt",
       {"collide", "--colider", "clip"},
       "no option '--colider'; did you mean '--collider'?"},
      {"a word too many", {"list", "regimes", "now"}, "unexpected argument 'now'"},
      {"list of an empty name", {"list", ""}, "no list of ''; there are colliders,"},
      {"list of an unknown thing", {"list", "wheels"}, "no list of 'wheels'; there are"},
      {"list of a thing that is misspelt",
       {"list", "regime"},
       "no list of 'regime'; did you mean 'regimes'? There are colliders, regimes,"},
      {"an unknown property",
       {"property", "swaping-mirrors"},
       "no property 'swaping-mirrors'; did you mean 'swapping-mirrors'?"},
      {"an unknown sweep", {"stress", "--sweep", "distanc"}, "did you mean 'distance'?"},
      {"an unknown scene", {"scene", "--scene", "pyramyd"}, "did you mean 'pyramid'?"},
      {"an unknown subject", {"bench", "--collider", "bacth"}, "did you mean 'batch'?"},
      {"no collider", {"collide"}, "--collider is required"},
      {"an unknown collider",
       {"collide", "--collider", "clop"},
       "no collider 'clop'; did you mean 'clip'?"},
      {"a negative tie bias",
       {"collide", "--collider", "clip", "--tie-bias", "-1"},
       "--tie-bias: '-1'"},
      {"a tie bias beyond double",
       {"collide", "--collider", "clip", "--tie-bias", "1e999"},
       "'1e999'"},
      {"a tie bias that is no number",
       {"collide", "--collider", "clip", "--tie-bias", "nan"},
       "'nan'"},
      {"a tie bias for Box2D",
       {"collide", "--collider", "box2d", "--tie-bias", "0"},
       "has a fixed tie bias"},
      {"two files", {"collide", "--collider", "clip", "a.jsonl", "b.jsonl"}, "b.jsonl"},
      {"an unknown regime",
       {"generate", "--regime", "genric"},
       "no regime 'genric'; did you mean 'generic'?\n"},
      {"a regime like no other",
       {"generate", "--regime", "xyzzy"},
       "no regime 'xyzzy'; there are generic, boxes,"},
      {"negative cases",
       {"generate", "--cases", "-5"},
       "--cases: '-5' is not a whole number from 1"},
      {"no cases", {"generate", "--cases", "0"}, "--cases: '0'"},
      {"fractional cases", {"generate", "--cases", "1.5"}, "--cases: '1.5'"},
      {"cases in powers", {"generate", "--cases", "1e6"}, "--cases: '1e6'"},
      {"an empty number", {"generate", "--cases", ""}, "--cases: ''"},
      {"a seed of 2^64",
       {"generate", "--seed", "18446744073709551616"},
       "--seed: '184467440737095516"},
      {"a radius beyond float", {"generate", "--radius", "1e300"}, "--radius: 1e+300 is too large"},
      {"a negative radius", {"generate", "--radius", "-1"}, "--radius: '-1'"},
      {"a negative seed", {"generate", "--seed", "-1"}, "--seed: '-1'"},
      {"a seed in odd bytes", {"generate", "--seed", "\x1b[31m1\n"}, "\\x1b[31m1\\x0a"},
      {"indices that pass 2^64",
       {"generate", "--seed", "1", "--regime", "generic", "--first", "18446744073709551615",
        "--cases", "2"},
       "--first"},
  };
  return all;
}

/// An example with fewer cases, and less of a smoke run's time.
std::string shortened(std::string example) {
  for (const auto& [text, shorter] : {std::pair<std::string_view, std::string_view>("00000", "000"),
                                      {"manifuzz smoke", "manifuzz smoke --seconds 3"}}) {
    for (std::size_t at = 0; (at = example.find(text, at)) != std::string::npos;) {
      example.replace(at, text.size(), shorter);
      at += shorter.size();
    }
  }
  return example;
}

void check_pasted(const std::string& example) {
  const TemporaryFolder folder;
  std::filesystem::copy(MANIFUZZ_SOURCE_DIR "/corpus", folder.path() / "corpus",
                        std::filesystem::copy_options::recursive);
  const std::string programs = std::filesystem::path(manifuzz_path()).parent_path().string();
  const Outcome outcome =
      run_program({"bash", "-c", "set -e -o pipefail; PATH=\"$1:$PATH\"; cd \"$2\"; eval \"$3\"",
                   "bash", programs, folder.path().string(), shortened(example)});
  INFO(example << "\n" << outcome.err);
  CHECK(outcome.status == 0);
}

[[maybe_unused]] const bool registered = [] {
  for (const auto& row : bad_usages()) {
    add_test("the command line refuses " + row.name, "[usage]", [&row] {
      const Outcome outcome = run_manifuzz(row.arguments);
      INFO(outcome.err);
      CHECK(outcome.status == 2);
      CHECK(outcome.out.empty());
      CHECK(is_one_clear_line(outcome.err));
      CHECK(outcome.err.find(row.complaint) != std::string::npos);
    });
  }
  for (const manifuzz::Command& command : manifuzz::commands()) {
    const std::string name(command.name);
    add_test("the example of " + name + " works when pasted", "[usage][longer]",
             [example = std::string(command.example)] { check_pasted(example); });
    add_test("help on " + name + " has an example", "[usage]", [name] {
      const Outcome outcome = run_manifuzz({name, "--help"});
      CHECK(outcome.status == 0);
      CHECK(outcome.err.empty());
      CHECK(outcome.out.find("Usage: manifuzz " + name) != std::string::npos);
      CHECK(outcome.out.find("Example:\n  ") != std::string::npos);
    });
  }
  return true;
}();

Outcome shell(const std::string& script) {
  return run_program({"/bin/sh", "-c", script, manifuzz_path()});
}

}  // namespace

TEST_CASE("Help and version go to stdout") {
  const Outcome help = run_manifuzz({"--help"});
  CHECK(help.status == 0);
  for (const auto& command : manifuzz::commands()) {
    CHECK(help.out.find("\n  " + std::string(command.name) + " ") != std::string::npos);
  }
  CHECK(run_manifuzz({"--version"}).out.starts_with("manifuzz "));
}

TEST_CASE("a command whose program is not built says what builds it") {
  const TemporaryFolder folder;
  const std::filesystem::path alone = folder.path() / "manifuzz";
  std::filesystem::copy(manifuzz_path(), alone);
  CHECK(run_program({alone.string(), "--help"}).out == run_manifuzz({"--help"}).out);
  const Outcome outcome = run_program({alone.string(), "--quiet", "bench", "--help"});
  CHECK(outcome.status == 2);
  CHECK(outcome.out.empty());
  CHECK(is_one_clear_line(outcome.err));
  CHECK(outcome.err.find("manifuzz-measure is not there; scripts/build builds it") !=
        std::string::npos);
}

TEST_CASE("list alone has a line for each list that there is") {
  const Outcome outcome = run_manifuzz({"list"});
  CHECK(outcome.status == 0);
  const auto lists = lines_of(outcome.out);
  CHECK(lists.size() == 7);
  for (const std::string& line : lists) {
    INFO(line);
    const auto entries = run_manifuzz({"list", line.substr(0, line.find(' '))});
    CHECK(entries.status == 0);
    CHECK_FALSE(entries.out.empty());
    CHECK(line.find_first_not_of(' ', line.find(' ')) != std::string::npos);
  }
}

TEST_CASE("list has a line for each collider and regime") {
  const auto colliders = lines_of(run_manifuzz({"list", "colliders"}).out);
  REQUIRE(colliders.size() >= 3);
  CHECK(colliders[0].starts_with("clip "));
  const auto regimes = lines_of(run_manifuzz({"list", "regimes"}).out);
  REQUIRE(regimes.size() >= 2);
  CHECK(regimes[0].starts_with("generic "));
}

TEST_CASE("collide takes a file of any white space, lines, and standard input") {
  const TemporaryFolder folder;
  std::string spread = good_case();
  spread.insert(1, "\n\n  ");
  const std::string expected = run_manifuzz({"collide", "--collider", "clip"}, good_case()).out;
  CHECK(lines_of(expected).size() == 1);
  for (const auto& file :
       {folder.write("a.json", spread + "\n"), folder.write("b.jsonl", good_case()),
        folder.write("c.txt", "\n" + good_case() + "\r\n\r\n")}) {
    const Outcome outcome = run_manifuzz({"collide", "--collider", "clip", file});
    CHECK(outcome.status == 0);
    CHECK(outcome.out == expected);
    CHECK(outcome.err.empty());
  }
  CHECK(run_manifuzz({"collide", "--collider", "clip", "-"}, good_case()).out == expected);
}

TEST_CASE("collide answers each case before it waits for the next") {
  const Outcome outcome = shell(
      "set -e; folder=$(mktemp -d); trap 'rm -r \"$folder\"' EXIT; cd \"$folder\"; mkfifo ask "
      "answer;"
      "\"$0\" collide --collider clip < ask > answer & exec 3> ask 4< answer;"
      "for i in 1 2 3; do echo '" +
      good_case() + "' >&3; read -r line <&4; echo \"$i $line\"; done; exec 3>&-; wait $!");
  CHECK(outcome.status == 0);
  const auto lines = lines_of(outcome.out);
  REQUIRE(lines.size() == 3);
  CHECK(lines[2].starts_with("3 {\"collider\": \"clip\""));
}

TEST_CASE("A reader that leaves ends the program quietly") {
  const Outcome outcome =
      shell("{ \"$0\" generate --seed 1 --cases 1000000; echo status $? >&2; } | head -n 1");
  CHECK(lines_of(outcome.out).size() == 1);
  CHECK(outcome.err == "status 0\n");
}

TEST_CASE("A full disk is one clear line") {
  const Outcome outcome = shell("\"$0\" list colliders > /dev/full");
  CHECK(outcome.status == 2);
  CHECK(outcome.err == "manifuzz: stdout: cannot write it: No space left on device\n");
}

TEST_CASE("A tie bias reaches the collider") {
  // B floats above A, a little tilted, and their skins touch: its face leads by 0.0036.
  const std::string pair =
      R"({"a": {"vertices": [[-1,-1],[1,-1],[1,1],[-1,1]], "radius": 0.1}, )"
      R"("b": {"vertices": [[-1.2,-1],[1.2,-1],[1.2,1],[-1.2,1]], "position": [0,2.05], )"
      R"("rotation": [0.9998,0.02]}})";
  const auto answer = [&pair](const std::string& bias) {
    return run_manifuzz({"collide", "--collider", "clip", "--tie-bias", bias}, pair).out;
  };
  CHECK(answer("0.003").find(R"("reference": "b")") != std::string::npos);
  CHECK(answer("0.004").find(R"("reference": "a")") != std::string::npos);
}

TEST_CASE("a file may be named without a folder") {
  const TemporaryFolder folder;
  const std::string boxes = MANIFUZZ_SOURCE_DIR "/corpus/seeds/regime-boxes.json";
  const Outcome outcome =
      run_program({"bash", "-c", "cd \"$1\" && \"$2\" show \"$3\" --svg picture.svg", "bash",
                   folder.path().string(), manifuzz_path(), boxes});
  INFO(outcome.err);
  CHECK(outcome.status == 0);
  CHECK(std::filesystem::exists(folder.path() / "picture.svg"));
}

TEST_CASE("a standard error that is closed or full changes no status") {
  const auto status = [](const std::string& line) {
    return run_program({"bash", "-c", "\"$0\" " + line, manifuzz_path()}).status;
  };
  CHECK(status("fuzz --bogus 2>/dev/full") == 2);
  CHECK(status("replay nonexistent 2>&-") == 2);
  CHECK(status("generate --cases 3 2>&-") == 0);
}
