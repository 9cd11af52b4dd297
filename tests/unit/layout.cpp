#include "unit/layout.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>

#include <fmt/format.h>

namespace manifuzz::test {
namespace {

/// cli -> {report, campaign, measure} -> judging -> {cases, oracle} -> geometry, and
/// {cli, measure} -> scene -> kernel -> clipping -> geometry. Of oracle/, the colliders outside
/// talk in the formats of cases/, and lend campaigns and measurements their processes.
const std::map<std::string, std::set<std::string>> kArrows = {
    {"cli", {"report", "campaign", "measure", "scene", "external"}},
    {"report", {"judging"}},
    {"campaign", {"judging", "external"}},
    {"measure", {"judging", "scene", "external"}},
    {"judging", {"cases", "oracle"}},
    {"cases", {"geometry"}},
    {"oracle", {"geometry"}},
    {"external", {"cases"}},
    {"scene", {"kernel"}},
    {"kernel", {"clipping"}},
    {"clipping", {"geometry"}},
    {"geometry", {}},
};

/// Beside these, names that begin with a dot.
const std::set<std::string> kTopLevel = {"CMakeLists.txt", "CMakePresets.json",
                                         "README.md",      "CHANGELOG.md",
                                         "LICENSE",        "src",
                                         "oracle",         "tests",
                                         "corpus",         "scripts"};

constexpr int kMaxLines = 400;

/// A folder of oracle/ that is a node of its own.
constexpr std::string_view kExternal = "oracle/external/";

std::string first_part(std::string_view path) {
  return std::string(path.substr(0, path.find('/')));
}

std::string_view after_first_part(std::string_view path) {
  const std::size_t slash = path.find('/');
  return slash == path.npos ? std::string_view() : path.substr(slash + 1);
}

bool reaches(const std::string& from, const std::string& to) {
  if (from == to) return true;
  const auto& below = kArrows.at(from);
  return std::any_of(below.begin(), below.end(),
                     [&](const std::string& next) { return reaches(next, to); });
}

/// The folder of the layout that a file of src or oracle belongs to; none for other files.
std::optional<std::string> folder_of(std::string_view path) {
  const std::string top = first_part(path);
  if (path.starts_with(kExternal)) return "external";
  if (top == "oracle") return top;
  if (top == "src") return first_part(after_first_part(path));
  return std::nullopt;
}

bool is_cpp(std::string_view path) {
  return path.ends_with(".hpp") || path.ends_with(".cpp");
}

/// What a line includes, without its quotes or brackets; empty where it includes nothing.
std::string_view included(std::string_view line) {
  const auto skip_blanks = [&line] {
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
  };
  const auto skip = [&](std::string_view word) {
    skip_blanks();
    if (!line.starts_with(word)) return false;
    line.remove_prefix(word.size());
    return true;
  };
  if (!skip("#") || !skip("include") || (!skip("\"") && !skip("<"))) return {};
  return line.substr(0, line.find_first_of("\">"));
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// Why a file of `folder` must not include `target`; none where it may.
std::optional<std::string> objection(const std::string& folder, std::string_view target) {
  if (target.find("../") != target.npos) return "includes are written from src/ or the top";
  const std::string to = target.starts_with(kExternal) ? "external" : first_part(target);
  if (to == "tests" || to == "support") return "tests are included by tests only";
  if (to == "src") return "includes are written from src/, without it";
  if (!kArrows.contains(to) || reaches(folder, to)) return std::nullopt;
  return fmt::format("{} lies not below {}", to, folder);
}

}  // namespace

Violations upward_includes(const std::vector<SourceFile>& files) {
  Violations found;
  for (const SourceFile& file : files) {
    const auto folder = folder_of(file.path);
    if (!folder || !is_cpp(file.path)) continue;
    if (!kArrows.contains(*folder)) {
      found.push_back(fmt::format("{}: the layout has no such folder", file.path));
      continue;
    }
    for (const std::string& line : lines_of(file.text)) {
      const auto why = objection(*folder, included(line));
      if (why) found.push_back(fmt::format("{}: {}: {}", file.path, line, *why));
    }
  }
  return found;
}

Violations long_files(const std::vector<SourceFile>& files) {
  const std::set<std::string> counted = {"src", "oracle", "tests", "scripts"};
  Violations found;
  for (const SourceFile& file : files) {
    const std::size_t lines = lines_of(file.text).size();
    const bool is_written_by_npm = file.path.ends_with("/package-lock.json");
    if (counted.contains(first_part(file.path)) && !is_written_by_npm && lines > kMaxLines) {
      found.push_back(fmt::format("{}: {} lines, at most {}", file.path, lines, kMaxLines));
    }
  }
  return found;
}

Violations stray_entries(const std::vector<SourceFile>& files) {
  Violations found;
  for (const SourceFile& file : files) {
    if (!file.path.starts_with('.') && !kTopLevel.contains(first_part(file.path))) {
      found.push_back(fmt::format("{}: not in the layout's top level", file.path));
    }
  }
  return found;
}

Violations machine_paths(const std::vector<SourceFile>& files) {
  // Split, so that this file does not name them.
  const std::vector<std::string> paths = {
      "/wo"
      "rk/",
      "/ho"
      "me/",
      "/ro"
      "ot/",
      "/tm"
      "p/helpers"};
  Violations found;
  for (const SourceFile& file : files) {
    for (const std::string& path : paths) {
      if (file.text.find(path) != std::string::npos) {
        found.push_back(fmt::format("{}: names {}", file.path, path));
      }
    }
  }
  return found;
}

}  // namespace manifuzz::test
