#include <cstdlib>
#include <filesystem>
#include <string>

#include <catch2/catch.hpp>

#include "support/run_program.hpp"
#include "support/source_tree.hpp"
#include "support/temporary_folder.hpp"

// scripts/ctest over a stand-in for ctest.

using namespace manifuzz::test;
using Catch::Contains;

namespace {

constexpr const char* kPassed =
    R"(	<testcase name="a/passes" classname="a/passes" time="1" status="run">
		<system-out>skipped: is a word here
</system-out>
	</testcase>
)";
constexpr const char* kSkipped =
    R"(	<testcase name="b/&quot;x&quot; &lt; 3%" classname="b" time="0" status="notrun">
		<skipped message="SKIP_RETURN_CODE=77"/>
		<system-out>this test is skipped: node is missing
</system-out>
	</testcase>
)";

/// scripts/ctest over tests with these results, of which ctest says `status`.
Outcome run_ctest(const std::string& results, int status,
                  const std::vector<std::string>& options = {}) {
  const TemporaryFolder folder;
  folder.write("results.xml", "<testsuite>\n" + results + "</testsuite>\n");
  const std::string program =
      folder.write("ctest",
                   "#!/bin/sh\necho \"$@\"\nwhile [ \"$1\" != --output-junit ]; do shift; done\n"
                   "cp \"${0%/*}/results.xml\" \"$2\"\nexit " +
                       std::to_string(status) + "\n");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  const std::vector<std::string> command{
      "env", "PATH=" + folder.path().string() + ":" + std::getenv("PATH"),
      (source_dir() / "scripts/ctest").string(), "release"};
  return run_program(with(command, options));
}

}  // namespace

TEST_CASE("tests that pass are no more than that") {
  const Outcome outcome = run_ctest(kPassed, 0, {"--all", "-R", "unit/"});
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.out, Contains("--preset release ") && Contains(" -R unit/\n"));
  CHECK_THAT(outcome.out, !Contains("skipped"));
}

TEST_CASE(
    "skipped tests are counted by their reason, and each is named and fails the run with --all") {
  const std::string results = std::string(kSkipped) + kPassed + kSkipped;
  const Outcome may_skip = run_ctest(results, 0);
  CHECK(may_skip.status == 0);
  CHECK_THAT(may_skip.out, Catch::EndsWith("2 skipped:\n      2 node is missing\n"));
  const Outcome all = run_ctest(results, 0, {"--all"});
  CHECK(all.status == 1);
  CHECK_THAT(all.out, Contains("  b/\"x\" < 3%: node is missing\n"));
}

TEST_CASE("a test that fails fails the run") {
  CHECK(run_ctest(kPassed, 8).status == 1);
}
