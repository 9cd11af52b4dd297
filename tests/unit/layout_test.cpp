#include "unit/layout.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <set>

#include <catch2/catch.hpp>

#include "support/source_tree.hpp"
#include "support/temporary_folder.hpp"
#include "unit/committed_tree.hpp"

using namespace manifuzz::test;
namespace fs = std::filesystem;

namespace {

const Violations kNone;

/// Whether a file of this path may include `target`.
bool may_include(const std::string& path, const std::string& target) {
  return forbidden_includes({{path, "#pragma once\n#include \"" + target + "\"\n"}}).empty();
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
  CHECK(forbidden_includes(tree()) == kNone);
}

TEST_CASE("the arrows between folders, as the includes draw them", "[.arrows]") {
  std::cout << drawing_of_arrows(tree());
  CHECK_FALSE(tree().empty());
}

TEST_CASE("no source file is over 300 lines") {
  CHECK(long_files(tree()) == kNone);
}

TEST_CASE("no folder has more than 24 modules") {
  CHECK(crowded_folders(tree()) == kNone);
}

TEST_CASE("the top level holds what the layout names") {
  CHECK(stray_entries(tree()) == kNone);
}

TEST_CASE("no file names a path of one machine") {
  CHECK(machine_paths(tree()) == kNone);
}

TEST_CASE("an include that points up is caught") {
  CHECK_FALSE(may_include("src/base/file.hpp", "process/pool.hpp"));
  CHECK_FALSE(may_include("src/geometry/pose.hpp", "clipping/clip.hpp"));
  CHECK_FALSE(may_include("src/clipping/clip.hpp", "kernel/pair.hpp"));
  CHECK_FALSE(may_include("src/kernel/pair.hpp", "afresh/afresh.hpp"));
  CHECK_FALSE(may_include("src/afresh/cells.hpp", "scene/scene.hpp"));
  CHECK_FALSE(may_include("src/clipping/clip.hpp", "methods/gjk.hpp"));
  CHECK_FALSE(may_include("src/methods/gjk.hpp", "kernel/pair.hpp"));
  CHECK_FALSE(may_include("src/exchange/json.cpp", "generating/regime.hpp"));
  CHECK_FALSE(may_include("src/generating/regime.cpp", "judging/judge.hpp"));
  CHECK_FALSE(may_include("src/judging/judge.cpp", "corpus/corpus.hpp"));
  CHECK_FALSE(may_include("src/corpus/shrink.cpp", "campaign/plan.hpp"));
  CHECK_FALSE(may_include("src/campaign/result.cpp", "measure/referee.hpp"));
  CHECK_FALSE(may_include("src/measure/bench/bench.cpp", "report/words.hpp"));
  CHECK_FALSE(may_include("src/report/words.cpp", "cli/options.hpp"));
  CHECK_FALSE(may_include("src/judging/judge.cpp", "engines/engine.hpp"));
}

TEST_CASE("the library includes nothing that is not installed with it") {
  for (const char* const file :
       {"src/geometry/pose.hpp", "src/clipping/clip.hpp", "src/kernel/pair.cpp",
        "src/scene/step.cpp", "src/methods/gjk.hpp"}) {
    CAPTURE(file);
    CHECK_FALSE(may_include(file, "base/random.hpp"));
    CHECK_FALSE(may_include(file, "process/pool.hpp"));
    CHECK_FALSE(may_include(file, "collider/collider.hpp"));
    CHECK_FALSE(may_include(file, "exact/truth.hpp"));
  }
}

TEST_CASE("an oracle or a judge that includes our own collider is caught") {
  for (const char* const file :
       {"src/exact/truth.cpp", "oracle/box2d/box2d.cpp", "src/external/library.cpp",
        "src/judging/judge.cpp", "src/generating/regime.cpp", "src/campaign/run.cpp",
        "src/exchange/json.cpp", "src/corpus/shrink.cpp"}) {
    for (const char* const ours :
         {"clipping/collide.hpp", "kernel/pair.hpp", "scene/scene.hpp", "methods/gjk.hpp",
          "own_colliders/own_colliders.hpp", "python/records.hpp"}) {
      CAPTURE(file, ours);
      CHECK_FALSE(may_include(file, ours));
    }
  }
}

TEST_CASE("whatever in src knows an engine is caught") {
  for (const char* const file : {"src/judging/judge.cpp", "src/engines/engine.cpp",
                                 "src/measure/bench/bench.cpp", "src/cli/commands/bench.cpp"}) {
    CAPTURE(file);
    CHECK_FALSE(may_include(file, "oracle/box2d/box2d.hpp"));
  }
  CHECK_FALSE(may_include("src/judging/judge.cpp", "external/external_collider.hpp"));
}

TEST_CASE("an engine includes its one ancestor, and no other engine") {
  CHECK(may_include("oracle/planck/ledger.cpp", "oracle/box2d/edge_clips.hpp"));
  CHECK(may_include("oracle/planck/ledger.cpp", "judging/ledger.hpp"));
  CHECK_FALSE(may_include("oracle/box2d/edges.cpp", "oracle/jbox2d/edges.hpp"));
  CHECK_FALSE(may_include("oracle/planck/ledger.cpp", "oracle/box2d3/placed.hpp"));
  CHECK_FALSE(may_include("oracle/planck/ledger.cpp", "campaign/plan.hpp"));
}

TEST_CASE(
    "every engine's folder has an engine.json and a line in engines.txt, and stands by itself") {
  const std::string listed = text_of(source_dir() / "oracle" / "engines.txt");
  std::set<std::string> names;
  for (const SourceFile& file : tree()) {
    if (!file.path.starts_with("oracle/")) continue;
    const std::size_t end = file.path.find('/', 7);
    if (end != std::string::npos) names.insert(file.path.substr(7, end - 7));
  }
  CHECK(static_cast<std::size_t>(std::ranges::count(listed, '\n')) == names.size());
  for (const std::string& name : names) {
    CAPTURE(name);
    CHECK(("\n" + listed).find("\n" + name + "\n") != std::string::npos);
    const std::string json = text_of(source_dir() / "oracle" / name / "engine.json");
    const std::string ancestor(ancestor_of(name));
    const std::string said = "\"descends_from\": \"" + ancestor + "\"";
    CHECK((json.find("descends_from") != std::string::npos) == !ancestor.empty());
    CHECK((ancestor.empty() || json.find(said) != std::string::npos));
  }
}

TEST_CASE("an include is recognised however it is written") {
  for (const char* line : {"#include <clipping/clip.hpp>", "#  include  \"clipping/clip.hpp\"",
                           "\t#include \"clipping/clip.hpp\"  // why"}) {
    CAPTURE(line);
    CHECK(forbidden_includes({{"src/geometry/pose.hpp", line}}).size() == 1);
  }
  CHECK_FALSE(may_include("src/geometry/pose.hpp", "src/clipping/clip.hpp"));
  CHECK_FALSE(may_include("src/geometry/pose.hpp", "../clipping/clip.hpp"));
  CHECK_FALSE(may_include("src/geometry/pose.hpp", "tests/support/source_tree.hpp"));
  CHECK_FALSE(may_include("src/geometry/pose.hpp", "support/source_tree.hpp"));
}

TEST_CASE("a folder that the layout does not name is caught") {
  CHECK(forbidden_includes({{"src/utils/misc.hpp", "#pragma once\n"}}).size() == 1);
  CHECK(forbidden_includes({{"src/main.cpp", "int main() {}\n"}}).size() == 1);
}

TEST_CASE("includes that point down, or stay, are allowed") {
  CHECK(may_include("src/cli/main.cpp", "geometry/pose.hpp"));
  CHECK(may_include("src/cli/main.cpp", "kernel/pair.hpp"));
  CHECK(may_include("src/cli/options.cpp", "engines/colliders.hpp"));
  CHECK(may_include("src/report/words.cpp", "exchange/json.hpp"));
  CHECK(may_include("src/measure/bench/bench.cpp", "scene/scene.hpp"));
  CHECK(may_include("src/measure/bench/bench.cpp", "judging/judge.hpp"));
  CHECK(may_include("src/judging/judge.cpp", "exact/truth.hpp"));
  CHECK(may_include("src/python/judge.cpp", "judging/judge.hpp"));
  CHECK(may_include("src/python/batch.cpp", "kernel/batch.hpp"));
  CHECK(may_include("src/clipping/collide.hpp", "clipping/clip.hpp"));
  CHECK(may_include("src/external/library.cpp", "exchange/json.hpp"));
  CHECK(may_include("src/geometry/pose.hpp", "Eigen/Core"));
  CHECK(may_include("tests/unit/clipping/steps_test.cpp", "cli/main.hpp"));
}

TEST_CASE("the arrows are drawn in the layout's order") {
  const std::string drawn = drawing_of_arrows(
      {{"src/judging/judge.cpp", "#include \"exact/truth.hpp\"\n#include \"base/text.hpp\"\n"},
       {"src/base/text.cpp", "#include \"base/text.hpp\"\n"}});
  CHECK(drawn.find("judging              -> base, exact\n") != std::string::npos);
  CHECK(drawn.find("base                 -> \n") != std::string::npos);
}

TEST_CASE("a file over 300 lines is caught, wherever sources lie") {
  std::string text;
  for (int i = 0; i < 300; ++i) text += "\n";
  for (const char* path : {"src/cli/main.cpp", "src/exact/exact.hpp", "tests/unit/a_test.cpp",
                           "src/report/page/dom.js", "scripts/test"}) {
    CAPTURE(path);
    CHECK(long_files({{path, text}}).empty());
    CHECK(long_files({{path, text + "one more"}}).size() == 1);
  }
  CHECK(long_files({{"README.md", text + "one more"}}).empty());
  CHECK(long_files({{"tests/canary/edits.txt", text + "one more"}}).empty());
}

TEST_CASE("a folder of more than 24 modules is caught") {
  std::vector<SourceFile> files;
  for (int i = 0; i < 24; ++i) {
    const std::string module = "src/cli/module" + std::to_string(i);
    files.push_back({module + ".hpp", ""});
    files.push_back({module + ".cpp", ""});
  }
  CHECK(crowded_folders(files).empty());
  files.push_back({"src/cli/commands/another.cpp", ""});
  files.push_back({"src/cli/README.md", ""});
  CHECK(crowded_folders(files).empty());
  files.push_back({"src/cli/another.hpp", ""});
  CHECK(crowded_folders(files).size() == 1);
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
