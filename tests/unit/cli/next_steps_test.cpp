#include <filesystem>

#include <catch2/catch.hpp>

#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

using namespace manifuzz::test;
using Catch::Contains;

namespace {

Outcome bare_call_in(const std::filesystem::path& folder) {
  return run_program({"sh", "-c", "cd \"$1\" && \"$0\"", manifuzz_path(), folder.string()});
}

/// The commands it gives: the lines that are indented.
std::vector<std::string> commands_in(const std::string& text) {
  std::vector<std::string> commands;
  for (const std::string& line : lines_of(text)) {
    if (line.starts_with("  ")) commands.push_back(line.substr(2));
  }
  return commands;
}

}  // namespace

TEST_CASE("a bare call gives the next steps on stdout, and the status of bad usage") {
  const TemporaryFolder folder;
  const Outcome outcome = bare_call_in(folder.path());
  CHECK(outcome.status == 2);
  CHECK(is_one_clear_line(outcome.err));
  CHECK_THAT(outcome.err, Contains("a command is missing"));
  CHECK(lines_of(outcome.out).size() <= 12);
  CHECK(outcome.out.find("replay") == std::string::npos);  // there is nothing to replay
}

TEST_CASE("the next steps work when pasted, with a corpus and without") {
  for (const bool has_corpus : {false, true}) {
    const TemporaryFolder folder;
    if (has_corpus) {
      std::filesystem::copy(MANIFUZZ_SOURCE_DIR "/corpus/seeds", folder.path() / "corpus",
                            std::filesystem::copy_options::recursive);
    }
    const Outcome steps = bare_call_in(folder.path());
    CHECK(lines_of(steps.out).size() <= 16);
    const auto commands = commands_in(steps.out);
    CHECK(commands.size() == (has_corpus ? 5U : 3U));
    for (std::string command : commands) {
      for (const std::string_view length : {"--seconds 10", "--cases 20000"}) {
        const std::size_t at = command.find(length);
        if (at != std::string::npos)
          command.replace(at, length.size(), "--cases 100 --seed 1 --no-save");
      }
      const Outcome outcome =
          run_program({"sh", "-c", "cd \"$0\" && " + command, folder.path().string()});
      CAPTURE(command, outcome.err);
      const bool has_box2d_as_subject = command.find("--collider box2d") != std::string::npos;
      CHECK(outcome.status == (has_box2d_as_subject ? 1 : 0));  // 1: it found what is wrong
    }
  }
}

TEST_CASE("the case to look at is one that tells something, wherever it lies") {
  const TemporaryFolder folder;
  std::filesystem::copy(MANIFUZZ_SOURCE_DIR "/corpus", folder.path() / "corpus",
                        std::filesystem::copy_options::recursive);
  CHECK_THAT(bare_call_in(folder.path()).out, Contains(" show corpus/regressions/"));
  std::filesystem::remove_all(folder.path() / "corpus" / "regressions");
  CHECK_THAT(bare_call_in(folder.path()).out, Contains(" show corpus/defects/box2d/"));
}
