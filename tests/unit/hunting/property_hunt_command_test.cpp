#include <filesystem>

#include <catch2/catch.hpp>

#include "support/interruption.hpp"
#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

using namespace manifuzz::test;

namespace {

std::vector<std::string> property(const TemporaryFolder& folder,
                                  const std::vector<std::string>& more) {
  return with({"property", "--hunt", "--corpus", (folder.path() / "corpus").string()}, more);
}

}  // namespace

TEST_CASE("a hunt of properties says what is wrong with what it is given, in a line") {
  const TemporaryFolder folder;
  const std::vector<std::vector<std::string>> wrong{{"--jobs", "0"},  {"--jobs", "many"},
                                                    {"--cases", "0"}, {"--hunt=perhaps"},
                                                    {"no-such-name"}, {"--subject", "cached"}};
  for (const std::vector<std::string>& options : wrong) {
    CAPTURE(options);
    const Outcome outcome = run_manifuzz(property(folder, options));
    CAPTURE(outcome.err);
    CHECK(outcome.status == 2);
    CHECK(std::ranges::count(outcome.err, '\n') == 1);
    CHECK(outcome.out.empty());
  }
  CHECK(run_manifuzz({"property", "--jobs", "2"}).status == 2);  // nothing to share
  const Outcome repeated = run_program(
      with({"env", "RC_PARAMS=reproduce=xx", manifuzz_path()}, property(folder, {})), "");
  CHECK(repeated.status == 2);
  CHECK(repeated.err.find("RC_PARAMS") != std::string::npos);
}

TEST_CASE("a hunt of properties says how much of their bounds is taken, and how it is repeated") {
  const TemporaryFolder folder;
  const Outcome holds = run_manifuzz(property(folder, {"--seed", "1", "--cases", "1500"}));
  CAPTURE(holds.out, holds.err);
  CHECK(holds.status == 0);
  CHECK(holds.out.find("hunted 1500 cases in ") != std::string::npos);
  CHECK(holds.out.find(" of its bound") != std::string::npos);

  const std::string silent = "sh " + folder.write("silent.sh",
                                                  "while read -r line; do\n"
                                                  "  echo '{\"points\": []}'\n"
                                                  "done\n");
  const Outcome fails =
      run_manifuzz(property(folder, {"never-empty", "admissible", "--subject-command", silent,
                                     "--seed", "1", "--cases", "60", "--no-save"}));
  CAPTURE(fails.out, fails.err);
  CHECK(fails.status == 1);
  CHECK(fails.out.find("FAIL never-empty") != std::string::npos);
  CHECK(fails.out.find(" property never-empty admissible --hunt --cases 60 ") != std::string::npos);
  CHECK(fails.out.find("RC_PARAMS") == std::string::npos);
}

TEST_CASE("a hunt of properties that is interrupted keeps what it found") {
  const TemporaryFolder folder;
  const Outcome outcome = run_interruptible(
      property(folder, {"never-empty", "--subject-command", interrupting_blind(folder, 100),
                        "--seed", "1", "--cases", "1000000"}));
  CAPTURE(outcome.err, outcome.out);
  CHECK(outcome.status == 1);
  CHECK(outcome.err.find("interrupted") != std::string::npos);
  CHECK(outcome.out.find("FAIL never-empty") != std::string::npos);
  CHECK_FALSE(std::filesystem::is_empty(folder.path() / "corpus/regressions"));
}
