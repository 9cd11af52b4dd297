#include <filesystem>
#include <map>
#include <sys/stat.h>

#include <catch2/catch.hpp>

#include "support/bad_cases.hpp"
#include "support/permissions.hpp"
#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

using namespace manifuzz::test;

namespace {

/// Replays a folder that holds a good case, and files that each have one clear line against them:
/// FILE: COMPLAINT. The good case is replayed all the same.
void check_broken(const TemporaryFolder& folder, const std::map<std::string, std::string>& broken) {
  folder.write("good.json", good_case());
  const Outcome outcome = run_manifuzz({"replay", folder.path()});
  INFO(outcome.out << outcome.err);
  CHECK(outcome.status == 2);
  CHECK(outcome.out.find("1 case, 1 passed, 0 failed") != std::string::npos);
  const auto lines = lines_of(outcome.err);
  REQUIRE(lines.size() == broken.size() + 1);
  std::size_t i = 0;
  for (const auto& [file, complaint] : broken) {
    CHECK(is_one_clear_line(lines[i] + "\n"));
    CHECK(lines[i].starts_with("manifuzz: " + (folder.path() / file).string() + ":"));
    CHECK(lines[i].find(complaint) != std::string::npos);
    ++i;
  }
  CHECK(lines.back() == "manifuzz: replay: " + std::to_string(broken.size()) +
                            " of the files could not be read; the others were replayed");
}

}  // namespace

TEST_CASE("replay refuses bad files, each by its name and what is wrong, and replays the rest",
          "[bad-input]") {
  const TemporaryFolder folder;
  std::map<std::string, std::string> broken;
  for (const BadCase& row : bad_case_of_each_kind()) {
    const std::string name = "bad" + std::to_string(broken.size()) + ".json";
    folder.write(name, row.text);
    broken[name] = row.complaint;
  }
  folder.write("blank.jsonl", "\n\n");
  folder.write("empty.json", "");
  folder.write("lines.jsonl", "{}\n[]\n");
  std::filesystem::create_symlink("nowhere", folder.path() / "link.json");
  broken.insert({{"blank.jsonl", "is empty"},
                 {"empty.json", "is empty"},
                 {"lines.jsonl", ":1: $: the key \"a\" is missing"},
                 {"link.json", "No such file"}});
  check_broken(folder, broken);
}

TEST_CASE("replay refuses a file without permission", "[bad-input]") {
  const BoundByPermissions bound;
  const TemporaryFolder folder;
  chmod(folder.write("bad.json", good_case()).c_str(), 0);
  check_broken(folder, {{"bad.json", "Permission denied"}});
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
