#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

#include <catch2/catch.hpp>

#include "support/source_tree.hpp"
#include "support/temporary_folder.hpp"
#include "unit/committed_tree.hpp"

// No source of src names an engine: what it knows of them is what their folders say.

using namespace manifuzz::test;

namespace {

/// The folders of oracle/, and the colliders that each engine.json names.
std::set<std::string> engine_names() {
  std::set<std::string> names;
  static const std::regex name("\"name\": \"([^\"]+)\"");
  std::istringstream listed(text_of(source_dir() / "oracle" / "engines.txt"));
  for (std::string folder; std::getline(listed, folder);) {
    names.insert(folder);
    const std::string json = text_of(source_dir() / "oracle" / folder / "engine.json");
    for (std::sregex_iterator at(json.begin(), json.end(), name), end; at != end; ++at) {
      names.insert((*at)[1]);
    }
  }
  return names;
}

/// Names that the command line's contract fixes, and where; "sat" is a method of this repository
/// too.
bool is_fixed(const std::string& path, const std::string& line) {
  const bool is_example =
      path == "src/cli/commands.cpp" && line.find("manifuzz ") != std::string::npos;
  return is_example || line.find("cached-bullet") != std::string::npos ||
         line.find("speedup_over_box2d") != std::string::npos ||
         (path == "src/measure/bench/bench.hpp" && line.find("kRatioBase") != std::string::npos) ||
         (path.starts_with("src/measure/") && line.find("\"sat\"") != std::string::npos) ||
         (path == "src/report/measurements/bench_report.cpp" &&
          line.find("\"x box2d\"") != std::string::npos);
}

bool is_part_of_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool has_word(const std::string& text, const std::string& word) {
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    const bool begins = at == 0 || !is_part_of_word(text[at - 1]);
    const std::size_t end = at + word.size();
    if (begins && (end == text.size() || !is_part_of_word(text[end]))) return true;
  }
  return false;
}

Violations named_engines(const std::vector<SourceFile>& files) {
  static const std::set<std::string> names = engine_names();
  Violations found;
  for (const SourceFile& file : files) {
    const bool is_cpp = file.path.ends_with(".cpp") || file.path.ends_with(".hpp");
    if (!file.path.starts_with("src/") || !is_cpp) continue;
    std::istringstream lines(file.text);
    for (std::string line; std::getline(lines, line);) {
      const std::string code = line.substr(0, line.find("//"));
      const auto is_in_code = [&](const std::string& name) { return has_word(code, name); };
      if (is_fixed(file.path, code)) continue;
      if (std::ranges::any_of(names, is_in_code)) found.push_back(file.path + ": " + line);
    }
  }
  return found;
}

}  // namespace

TEST_CASE("no source of src names an engine") {
  CHECK(named_engines(tree()) == Violations{});
}

TEST_CASE("an engine that is named is caught, in code alone") {
  CHECK(named_engines({{"src/report/words.cpp", "return name == \"planck\";"}}).size() == 1);
  CHECK(named_engines({{"src/judging/judge.cpp", "find(\"parry2d-f64\")"}}).size() == 1);
  CHECK(named_engines({{"src/report/words.cpp", "x = 1;  // as planck has it"}}).empty());
  CHECK(named_engines({{"src/report/words.cpp", "satisfies(box2dish)"}}).empty());
  CHECK(named_engines({{"oracle/planck/engine.cpp", "\"planck\""}}).empty());
}
