#include <string>

#include <catch2/catch.hpp>

#include "support/run_program.hpp"
#include "support/source_tree.hpp"

using namespace manifuzz::test;
using Catch::Contains;

namespace {

/// scripts/quietly over a shell's commands.
std::vector<std::string> quietly(const std::string& commands) {
  return {(source_dir() / "scripts/quietly").string(), "sh", "-c", commands};
}

/// The last line of what it says of commands that fail.
std::string last_line_after(const std::string& commands) {
  const Outcome outcome = run_program(quietly(commands + "; exit 3"));
  CHECK(outcome.status == 3);
  CHECK(outcome.out.empty());
  return lines_of(outcome.err).back();
}

}  // namespace

TEST_CASE("what succeeds is quiet") {
  const Outcome outcome = run_program(quietly("echo all; echo well >&2"));
  CHECK(outcome.status == 0);
  CHECK(outcome.out.empty());
  CHECK(outcome.err.empty());
}

TEST_CASE("what fails shows its output, and last what helps") {
  const Outcome outcome = run_program(quietly("echo out; echo err >&2; exit 3"));
  CHECK(outcome.status == 3);
  CHECK_THAT(outcome.err, Contains("out\nerr\nfailed with status 3: sh -c"));
  CHECK_THAT(last_line_after("echo 'a.cpp:1:2: error: no'; echo 'a.cpp:3:4: error: nor this'"),
             Catch::Equals("this does not compile: a.cpp:1:2: error: no"));
  CHECK_THAT(last_line_after("echo 'a.cpp:1:2: error: writing: No space left on device'"),
             Contains("the disk is full: make room"));
  CHECK_THAT(last_line_after("echo 'E: Unable to locate package cmake'"), Contains("network"));
  CHECK_THAT(last_line_after("echo ' Could not find a package configuration file provided by x'"),
             Contains("cmake misses what scripts/setup installs"));
}

TEST_CASE("how far ninja is, is told every 10 %, and on a terminal at every file") {
  const std::string built =
      "echo '[0/2] Re-checking'; for i in $(seq 40); do echo \"[$i/40] Building\"; done";
  const Outcome outcome = run_program(quietly(built));
  const auto lines = lines_of(outcome.err);
  CHECK(lines.size() == 11);
  CHECK(lines.back() == "built 40 of 40 files");
  const std::string shown = run_on_terminal(quietly(built)).out;
  CHECK_THAT(shown, Contains("\r\033[Kbuilt 39 of 40 files\r\033[Kbuilt 40 of 40 files"));
}

TEST_CASE("how far apt-get is, is told by package") {
  const Outcome outcome =
      run_program(quietly("echo Get:1; echo '1 upgraded, 4 newly installed, 0 to remove'; "
                          "echo 'Need to get 7 MB of archives.'; "
                          "for s in Get: 'Unpacking ' 'Setting up '; do for i in 1 2 3 4 5; do "
                          "echo \"$s$i\"; done; done"));
  const auto lines = lines_of(outcome.err);
  CHECK(lines.front() == "5 packages, 7 MB to download");
  CHECK(lines[1] == "downloaded 1 of 5 packages");
  CHECK(lines.back() == "set up 5 of 5 packages");
}
