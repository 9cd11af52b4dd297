#include <fstream>
#include <regex>
#include <set>

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "support/source_tree.hpp"
#include "support/temporary_folder.hpp"
#include "unit/committed_tree.hpp"

// An engine's version stands in its engine.json, in what pins it for whoever installs it, and with
// what was measured: nowhere else, where it would have to be kept in step by hand.

using namespace manifuzz::test;

namespace {

/// What sources may say of an engine's version, and where.
struct Versioned {
  std::string folder;           ///< oracle/NAME/
  std::set<std::string> parts;  ///< of its version: 3.2.0 and 56edae79 of "3.2.0, commit 56edae79"
  std::set<std::string> names;  ///< its folder's and its colliders'
};

std::set<std::string> all_matches(const std::string& text, const std::regex& sought) {
  std::set<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), sought), end; at != end; ++at) {
    found.insert((*at)[1]);
  }
  return found;
}

Versioned versioned(const std::string& name, const std::string& engine_json) {
  static const std::regex version("\"version\": \"([^\"]*)\"");
  static const std::regex part("([0-9a-z.]*[0-9][0-9a-z.]*)");
  static const std::regex collider("\"name\": \"([^\"]*)\"");
  Versioned engine{"oracle/" + name + '/', {}, all_matches(engine_json, collider)};
  engine.names.insert(name);
  for (const std::string& whole : all_matches(engine_json, version)) {
    engine.parts.merge(all_matches(whole, part));
  }
  return engine;
}

std::vector<Versioned> versioned_engines() {
  std::vector<Versioned> engines;
  std::ifstream listed(source_dir() / "oracle" / "engines.txt");
  for (std::string name; std::getline(listed, name);) {
    engines.push_back(versioned(name, text_of(source_dir() / "oracle" / name / "engine.json")));
  }
  return engines;
}

/// Whether a text has that part of an engine's version: anywhere in the engine's own folder,
/// elsewhere after one of its names.
bool has_version(const std::string& text, const std::string& part, const Versioned& engine,
                 bool is_its_own) {
  if (text.find(part) == std::string::npos) return false;
  const std::string dots = std::regex_replace(part, std::regex("\\."), "\\.");
  const std::string before =
      is_its_own ? "(^|[^\\w.])" : fmt::format("\\b({}) ", fmt::join(engine.names, "|"));
  const std::regex sought(before + "v?" + dots + "(?!\\w|\\.\\d)", std::regex::icase);
  return std::regex_search(text, sought);
}

/// What of a file is looked at: sources, and of an engine's README the title.
std::string looked_at(const SourceFile& file) {
  static const std::set<std::string> endings = {"cpp",  "hpp", "c",  "h",   "rs",
                                                "java", "go",  "py", "mjs", "gd"};
  if (!file.path.starts_with("src/") && !file.path.starts_with("oracle/")) return {};
  if (file.path.ends_with("/README.md")) return file.text.substr(0, file.text.find('\n'));
  return endings.contains(file.path.substr(file.path.rfind('.') + 1)) ? file.text : std::string();
}

Violations stray_versions(const std::vector<SourceFile>& files,
                          const std::vector<Versioned>& engines) {
  Violations found;
  for (const SourceFile& file : files) {
    const std::string text = looked_at(file);
    for (const Versioned& engine : engines) {
      const bool is_its_own = file.path.starts_with(engine.folder);
      for (const std::string& part : engine.parts) {
        if (!has_version(text, part, engine, is_its_own)) continue;
        found.push_back(file.path + ": " + part + " stands in " + engine.folder + "engine.json");
      }
    }
  }
  return found;
}

}  // namespace

TEST_CASE("an engine's version stands in its engine.json alone") {
  CHECK(versioned_engines().size() > 15);
  CHECK(stray_versions(tree(), versioned_engines()) == Violations{});
}

TEST_CASE("a version that stands elsewhere is caught") {
  const std::vector<Versioned> engines = {
      versioned("bullet", R"({"version": "3.24", "colliders": [{"name": "bullet-epa"}]})"),
      versioned("box2d3", R"({"version": "3.2.0, commit 56edae79", "colliders": []})")};
  const auto stray = [&](const std::string& path, const std::string& text) {
    return stray_versions({{path, text}}, engines).size();
  };
  CHECK(stray("src/sequence/a.cpp", "\"Bullet 3.24, btA.cpp\"") == 1);
  CHECK(stray("oracle/libccd/a.hpp", "// as bullet-epa v3.24.") == 1);
  CHECK(stray("oracle/bullet/a.hpp", "version = \"3.24\"") == 1);
  CHECK(stray("oracle/box2d3/adapter/src/lib.rs", "c\"3.2.0, snapshot 56edae79\"") == 2);
  CHECK(stray("oracle/box2d3/README.md", "# Box2D 3.2.0\n") == 1);
  CHECK(stray("oracle/box2d3/README.md", "# Box2D 3\nMeasured with 3.2.0.\n") == 0);
  CHECK(stray("oracle/bullet/a.hpp", "13.24, 3.241, 3.24.1") == 0);
  CHECK(stray("src/measure/a.cpp", "x = 3.24;") == 0);
  CHECK(stray("oracle/bullet/engine.json", "\"version\": \"3.24\"") == 0);
  CHECK(stray("tests/unit/a_test.cpp", "bullet 3.24") == 0);
}
