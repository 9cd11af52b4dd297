#include "unit/layout.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>

#include <catch2/catch.hpp>

#include "support/run_program.hpp"
#include "support/source_tree.hpp"
#include "support/temporary_folder.hpp"

using namespace manifuzz::test;
namespace fs = std::filesystem;

namespace {

/// The paths git keeps; in a tree without git, every file of the folders that hold sources.
std::vector<std::string> committed_paths() {
  std::vector<std::string> paths;
  std::string listed;
  if (fs::exists(source_dir() / ".git")) {
    const std::string top = source_dir().string();
    listed = run_program({"env", "git", "-c", "safe.directory=*", "-C", top, "ls-files", "-z"}).out;
  }
  for (std::size_t begin = 0; begin < listed.size();) {
    const std::size_t end = listed.find('\0', begin);
    paths.push_back(listed.substr(begin, end - begin));
    begin = end + 1;
  }
  if (!paths.empty()) return paths;
  for (const char* folder : {"src", "oracle", "tests", "corpus", "scripts"}) {
    if (!fs::exists(source_dir() / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(source_dir() / folder)) {
      paths.push_back(fs::relative(entry.path(), source_dir()).generic_string());
    }
  }
  return paths;
}

/// Every committed file that is there, read once.
const std::vector<SourceFile>& tree() {
  static const std::vector<SourceFile> files = [] {
    std::vector<SourceFile> found;
    for (const std::string& path : committed_paths()) {
      if (fs::is_regular_file(source_dir() / path))
        found.push_back({path, text_of(source_dir() / path)});
    }
    return found;
  }();
  return files;
}

/// Whether a file of this path may include `target`.
bool may_include(const std::string& path, const std::string& target) {
  return upward_includes({{path, "#pragma once\n#include \"" + target + "\"\n"}}).empty();
}

}  // namespace

TEST_CASE("the tree is read") {
  CHECK(tree().size() > 20);
  CHECK(std::any_of(tree().begin(), tree().end(), [](const SourceFile& file) {
    return file.path == "src/geometry/pose.hpp" &&
           file.text.find("struct Pose") != std::string::npos;
  }));
}

TEST_CASE("includes point one way") {
  CHECK(upward_includes(tree()) == Violations{});
}

TEST_CASE("no source file is over 400 lines") {
  CHECK(long_files(tree()) == Violations{});
}

TEST_CASE("the top level holds what the layout names") {
  CHECK(stray_entries(tree()) == Violations{});
}

TEST_CASE("no file names a path of one machine") {
  CHECK(machine_paths(tree()) == Violations{});
}

TEST_CASE("an include that points up is caught") {
  CHECK_FALSE(may_include("src/geometry/pose.hpp", "clipping/clip.hpp"));
  CHECK_FALSE(may_include("src/clipping/clip.hpp", "kernel/kernel.hpp"));
  CHECK_FALSE(may_include("src/kernel/kernel.hpp", "scene/scene.hpp"));
  CHECK_FALSE(may_include("src/cases/json.cpp", "judging/verdict.hpp"));
  CHECK_FALSE(may_include("src/judging/verdict.cpp", "campaign/campaign.hpp"));
  CHECK_FALSE(may_include("src/campaign/jobs.cpp", "cli/colliders.hpp"));
  CHECK_FALSE(may_include("src/geometry/pose.hpp", "oracle/exact/exact.hpp"));
}

TEST_CASE("an include across is caught") {
  CHECK_FALSE(may_include("src/cases/json.cpp", "oracle/box2d/box2d.hpp"));
  CHECK_FALSE(may_include("src/judging/verdict.cpp", "clipping/collide.hpp"));
  CHECK_FALSE(may_include("src/campaign/campaign.cpp", "report/svg.hpp"));
  CHECK_FALSE(may_include("src/campaign/campaign.cpp", "clipping/collide.hpp"));
  CHECK_FALSE(may_include("src/clipping/clip.hpp", "cases/random.hpp"));
}

TEST_CASE("an oracle that includes our own collider is caught") {
  CHECK_FALSE(may_include("oracle/box2d/box2d.cpp", "clipping/collide.hpp"));
  CHECK_FALSE(may_include("oracle/exact/exact.cpp", "kernel/kernel.hpp"));
  CHECK_FALSE(may_include("oracle/exact/exact.cpp", "cases/json.hpp"));
}

TEST_CASE("an include is recognised however it is written") {
  for (const char* line : {"#include <clipping/clip.hpp>", "#  include  \"clipping/clip.hpp\"",
                           "\t#include \"clipping/clip.hpp\"  // why"}) {
    CAPTURE(line);
    CHECK(upward_includes({{"src/geometry/pose.hpp", line}}).size() == 1);
  }
  CHECK_FALSE(may_include("src/geometry/pose.hpp", "src/clipping/clip.hpp"));
  CHECK_FALSE(may_include("src/geometry/pose.hpp", "../clipping/clip.hpp"));
  CHECK_FALSE(may_include("src/geometry/pose.hpp", "tests/support/source_tree.hpp"));
  CHECK_FALSE(may_include("src/geometry/pose.hpp", "support/source_tree.hpp"));
}

TEST_CASE("a folder that the layout does not name is caught") {
  CHECK(upward_includes({{"src/utils/misc.hpp", "#pragma once\n"}}).size() == 1);
  CHECK(upward_includes({{"src/main.cpp", "int main() {}\n"}}).size() == 1);
}

TEST_CASE("includes that point down, or stay, are allowed") {
  CHECK(may_include("src/cli/main.cpp", "geometry/pose.hpp"));
  CHECK(may_include("src/cli/main.cpp", "kernel/kernel.hpp"));
  CHECK(may_include("src/cli/main.cpp", "oracle/box2d/box2d.hpp"));
  CHECK(may_include("src/report/svg.cpp", "cases/json.hpp"));
  CHECK(may_include("src/measure/bench.cpp", "scene/scene.hpp"));
  CHECK(may_include("src/measure/bench.cpp", "judging/verdict.hpp"));
  CHECK(may_include("src/judging/verdict.cpp", "oracle/exact/exact.hpp"));
  CHECK(may_include("src/clipping/collide.hpp", "clipping/clip.hpp"));
  CHECK(may_include("oracle/box2d/box2d.cpp", "oracle/exact/exact.hpp"));
  CHECK(may_include("src/geometry/pose.hpp", "Eigen/Core"));
  CHECK(may_include("tests/unit/clipping/clip_test.cpp", "cli/main.hpp"));
}

TEST_CASE("a file over 400 lines is caught, wherever sources lie") {
  std::string text;
  for (int i = 0; i < 400; ++i) text += "\n";
  for (const char* path :
       {"src/cli/main.cpp", "oracle/exact/exact.hpp", "tests/unit/a_test.cpp", "scripts/test"}) {
    CAPTURE(path);
    CHECK(long_files({{path, text}}).empty());
    CHECK(long_files({{path, text + "one more"}}).size() == 1);
  }
  CHECK(long_files({{"README.md", text + "one more"}}).empty());
}

TEST_CASE("a stray entry at the top is caught") {
  CHECK(stray_entries({{"docs/index.md", ""}}).size() == 1);
  CHECK(stray_entries({{"notes.txt", ""}}).size() == 1);
  CHECK(
      stray_entries({{"README.md", ""}, {"src/cli/main.cpp", ""}, {".clang-format", ""}}).empty());
}

TEST_CASE("a machine's path is caught") {
  CHECK(machine_paths({{"README.md",
                        "see /ho"
                        "me/me/notes"}})
            .size() == 1);
  CHECK(machine_paths({{"corpus/ties/a.json",
                        "\"/wo"
                        "rk/x\""}})
            .size() == 1);
  CHECK(machine_paths({{"README.md", "build/release/manifuzz, how it works/fails"}}).empty());
}
