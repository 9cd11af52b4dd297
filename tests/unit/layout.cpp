#include "unit/layout.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace manifuzz::test {
namespace {

/// A folder: it may include itself and what stands before it in the list, but no hidden group.
struct Folder {
  std::string_view name;
  std::string_view group;
  std::vector<std::string_view> hidden;
};

/// The library is installed alone. What carries cases and what judges answers knows our code and
/// the engines by the collider's interface only: shared code shares bugs.
const std::vector<Folder> kFolders = {
    {"base", "tools", {}},
    {"process", "tools", {}},
    {"geometry", "geometry", {"tools"}},
    {"clipping", "own code", {"tools"}},
    {"methods", "own code", {"tools"}},
    {"kernel", "own code", {"tools"}},
    {"afresh", "own code", {"tools"}},
    {"scene", "own code", {"tools"}},
    {"collider", "collider", {"own code"}},
    {"own_colliders", "own code", {}},
    {"exchange", "exchange", {"own code"}},
    {"exact", "exact", {"own code", "tools"}},
    {"external", "external", {"own code"}},
    {"generating", "generating", {"own code", "external"}},
    {"judging", "judging", {"own code", "external"}},
    {"playground", "own code", {"tools"}},
    {"python", "own code", {"tools", "exchange", "external"}},
    {"properties", "properties", {"own code", "external"}},
    {"sequence", "sequence", {"own code", "external"}},
    {"corpus", "corpus", {"own code", "external"}},
    {"conformance", "conformance", {"own code", "external"}},
    {"engines", "engines", {}},
    {"campaign", "campaign", {"own code"}},
    {"hunting", "campaign", {"own code"}},
    {"measure", "measure", {}},
    {"report", "report", {"own code"}},
    {"cli", "cli", {}},
};

/// An engine is a folder of oracle/. It includes src, but for our own code and what commands are
/// made of, and the engine that it descends from.
const Folder kEngine{"an engine", "engine", {"own code", "cli", "report", "measure", "campaign"}};

/// By the engine that descends from it.
const std::map<std::string_view, std::string_view> kAncestors = {
    {"jbox2d", "box2d"},        {"planck", "box2d"},    {"box2d-core", "box2d"},
    {"phaser-box2d", "box2d3"}, {"pymunk", "chipmunk"}, {"cp", "chipmunk"},
    {"rapier", "parry"},        {"bullet", "libccd"}};

/// Beside these, names that begin with a dot.
const std::set<std::string> kTopLevel = {"CMakeLists.txt",
                                         "CMakePresets.json",
                                         "README.md",
                                         "CHANGELOG.md",
                                         "LICENSE",
                                         "pyproject.toml",
                                         "src",
                                         "oracle",
                                         "tests",
                                         "corpus",
                                         "scripts"};

constexpr std::size_t kMaxLines = 300;
constexpr std::size_t kMaxModules = 24;

std::string first_part(std::string_view path) {
  return std::string(path.substr(0, path.find('/')));
}

std::string_view after_first_part(std::string_view path) {
  const std::size_t slash = path.find('/');
  return slash == path.npos ? std::string_view() : path.substr(slash + 1);
}

/// The folder of the layout that a path below src/ or oracle/ belongs to, as includes write it.
std::string folder_of(std::string_view path) {
  std::string top = first_part(path);
  return top == "oracle" ? top + '/' + first_part(after_first_part(path)) : top;
}

/// The path of a file of src or oracle as includes write it; none for other files.
std::optional<std::string_view> included_as(std::string_view path) {
  if (path.starts_with("oracle/")) return path;
  if (path.starts_with("src/")) return after_first_part(path);
  return std::nullopt;
}

const Folder* find_folder(std::string_view name) {
  const auto found = std::ranges::find(kFolders, name, &Folder::name);
  return found == kFolders.end() ? nullptr : &*found;
}

bool is_engine(std::string_view folder) {
  return folder.starts_with("oracle/");
}

bool is_hidden(const Folder& from, const Folder& to) {
  return std::ranges::find(from.hidden, to.group) != from.hidden.end();
}

/// Why a file of `from` must not include one of `to`, folders of the layout; none where it may.
std::optional<std::string> objection_between(const std::string& from, const std::string& to) {
  const std::string no = fmt::format("{} may not include {}", from, to);
  if (from == to) return std::nullopt;
  if (is_engine(to)) {
    const bool descends = ancestor_of(after_first_part(from)) == after_first_part(to);
    return is_engine(from) && descends ? std::nullopt : std::optional(no);
  }
  const Folder* const target = find_folder(to);
  if (target == nullptr) return std::nullopt;  // none of ours
  const Folder* const own = is_engine(from) ? &kEngine : find_folder(from);
  const bool is_below = is_engine(from) || target < own;
  return is_below && !is_hidden(*own, *target) ? std::nullopt : std::optional(no);
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
  const std::string top = first_part(target);
  if (top == "tests" || top == "support") return "tests are included by tests only";
  if (top == "src") return "includes are written from src/, without it";
  return objection_between(folder, folder_of(target));
}

/// Whether it is a source of a program, not data or a table.
bool is_source(std::string_view path) {
  const auto ends = [path](std::string_view ending) { return path.ends_with(ending); };
  return is_cpp(path) || ends(".h") || ends(".js") || ends(".mjs") || path.starts_with("scripts/");
}

std::string folder_path(const std::string& path) {
  return path.substr(0, path.rfind('/'));
}

std::string module_of(const std::string& path) {
  return path.substr(0, path.rfind('.'));
}

std::map<std::string, std::set<std::string>> arrows(const std::vector<SourceFile>& files) {
  std::map<std::string, std::set<std::string>> drawn;
  for (const SourceFile& file : files) {
    const auto path = included_as(file.path);
    if (!path || !is_cpp(file.path)) continue;
    const std::string from = folder_of(*path);
    for (const std::string& line : lines_of(file.text)) {
      const std::string to = folder_of(included(line));
      if (to != from && (is_engine(to) || find_folder(to) != nullptr)) drawn[from].insert(to);
    }
  }
  return drawn;
}

/// The folders of src in their order, then the engines.
std::vector<std::string> drawn_folders(const std::map<std::string, std::set<std::string>>& drawn) {
  std::vector<std::string> folders;
  for (const Folder& folder : kFolders) folders.emplace_back(folder.name);
  for (const auto& [from, to] : drawn) {
    if (is_engine(from)) folders.push_back(from);
  }
  return folders;
}

}  // namespace

std::string_view ancestor_of(std::string_view engine) {
  const auto found = kAncestors.find(engine);
  return found == kAncestors.end() ? std::string_view() : found->second;
}

std::string drawing_of_arrows(const std::vector<SourceFile>& files) {
  const auto drawn = arrows(files);
  const std::vector<std::string> folders = drawn_folders(drawn);
  std::string text;
  for (const std::string& folder : folders) {
    std::vector<std::string> below;
    const auto of = drawn.find(folder);
    for (const std::string& other : folders) {
      if (of != drawn.end() && of->second.contains(other)) below.push_back(other);
    }
    text += fmt::format("{:<20} -> {}\n", folder, fmt::join(below, ", "));
  }
  return text;
}

Violations forbidden_includes(const std::vector<SourceFile>& files) {
  Violations found;
  for (const SourceFile& file : files) {
    const auto path = included_as(file.path);
    if (!path || !is_cpp(file.path)) continue;
    const std::string folder = folder_of(*path);
    if (!is_engine(folder) && find_folder(folder) == nullptr) {
      found.push_back(fmt::format("{}: the layout has no such folder", file.path));
      continue;
    }
    for (const std::string& line : lines_of(file.text)) {
      const auto why = objection(folder, included(line));
      if (why) found.push_back(fmt::format("{}: {}: {}", file.path, line, *why));
    }
  }
  return found;
}

Violations crowded_folders(const std::vector<SourceFile>& files) {
  std::map<std::string, std::set<std::string>> modules;
  for (const SourceFile& file : files) {
    if (included_as(file.path) && is_source(file.path)) {
      modules[folder_path(file.path)].insert(module_of(file.path));
    }
  }
  Violations found;
  for (const auto& [folder, of] : modules) {
    if (of.size() <= kMaxModules) continue;
    found.push_back(fmt::format("{}: {} modules, at most {}", folder, of.size(), kMaxModules));
  }
  return found;
}

Violations long_files(const std::vector<SourceFile>& files) {
  const std::set<std::string> counted = {"src", "oracle", "tests", "scripts"};
  Violations found;
  for (const SourceFile& file : files) {
    const std::size_t lines = lines_of(file.text).size();
    const bool is_lock_file =
        file.path.ends_with("/package-lock.json") || file.path.ends_with("/Cargo.lock");
    const bool counts = counted.contains(first_part(file.path)) && is_source(file.path);
    if (counts && !is_lock_file && lines > kMaxLines) {
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
  const std::string split = "/";  // so that this file does not name them
  const std::vector<std::string> paths = {split + "work/", split + "home/", split + "root/",
                                          split + "tmp/helpers"};
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
