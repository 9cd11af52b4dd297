#include <filesystem>
#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>

#include "support/bad_cases.hpp"
#include "support/named_tests.hpp"
#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

using namespace manifuzz::test;

namespace {

/// Replays a folder that holds a good case and something broken named `broken`: that gives one
/// clear line which contains `complaint`, and the good case is replayed all the same.
void check_broken(const TemporaryFolder& folder, const std::string& broken,
                  const std::string& complaint) {
  folder.write("good.json", good_case());
  const Outcome outcome = run_manifuzz({"replay", folder.path()});
  INFO(outcome.out << outcome.err);
  CHECK(outcome.status == 2);
  CHECK(outcome.out.find("1 cases, 1 passed, 0 failed") != std::string::npos);
  const auto lines = lines_of(outcome.err);
  REQUIRE(lines.size() == 2);
  CHECK(is_one_clear_line(lines[0] + "\n"));
  CHECK(lines[0].starts_with("manifuzz: " + (folder.path() / broken).string() + ":"));
  CHECK(lines[0].find(complaint) != std::string::npos);
  CHECK(lines[1] == "manifuzz: replay: 1 of the files could not be read; the rest was replayed");
}

[[maybe_unused]] const bool registered = [] {
  for (const auto& row : bad_cases()) {
    add_test("replay refuses " + row.name, "[bad-input]", [&row] {
      const TemporaryFolder folder;
      folder.write("bad.json", row.text);
      check_broken(folder, "bad.json", row.complaint);
    });
  }
  return true;
}();

}  // namespace

TEST_CASE("replay refuses an empty file", "[bad-input]") {
  const TemporaryFolder folder;
  folder.write("bad.json", "");
  check_broken(folder, "bad.json", "is empty");
}

TEST_CASE("replay refuses blank lines alone", "[bad-input]") {
  const TemporaryFolder folder;
  folder.write("bad.jsonl", "\n\n");
  check_broken(folder, "bad.jsonl", "is empty");
}

TEST_CASE("replay refuses a bad line", "[bad-input]") {
  const TemporaryFolder folder;
  folder.write("bad.jsonl", "{}\n[]\n");
  check_broken(folder, "bad.jsonl", ":1: $: the key \"a\" is missing");
}

TEST_CASE("replay refuses a link to nowhere", "[bad-input]") {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("nowhere", folder.path() / "bad.json");
  check_broken(folder, "bad.json", "No such file");
}

TEST_CASE("replay refuses a file without permission", "[bad-input]") {
  if (geteuid() == 0) {
    WARN("skipped: root may read everything");
    return;
  }
  const TemporaryFolder folder;
  chmod(folder.write("bad.json", good_case()).c_str(), 0);
  check_broken(folder, "bad.json", "Permission denied");
}

TEST_CASE("replay refuses paths without cases", "[bad-input]") {
  const TemporaryFolder folder;
  for (const std::string& path : {folder.path().string(), folder.path().string() + "/absent",
                                  folder.write("notes.txt", "hello")}) {
    const Outcome outcome = run_manifuzz({"replay", path});
    INFO(outcome.err);
    CHECK(outcome.status == 2);
    for (const auto& line : lines_of(outcome.err)) CHECK(is_one_clear_line(line + "\n"));
    CHECK(!outcome.err.empty());
  }
}
