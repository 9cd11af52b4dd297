#pragma once

#include <string>
#include <vector>

namespace manifuzz::test {

/// A file of the tree: its path from the top ("src/geometry/pose.hpp") and its text.
struct SourceFile {
  std::string path;
  std::string text;
};

/// What breaks a rule of the layout, a line each: the file, and what would be right.
using Violations = std::vector<std::string>;

/// Includes may point from a folder to those below it, and into its own, nowhere else.
Violations upward_includes(const std::vector<SourceFile>& files);

/// Source files (src, oracle, tests, scripts) of more than 400 lines.
Violations long_files(const std::vector<SourceFile>& files);

/// Files whose top-level entry the layout does not name.
Violations stray_entries(const std::vector<SourceFile>& files);

/// Paths that exist on one machine only.
Violations machine_paths(const std::vector<SourceFile>& files);

}  // namespace manifuzz::test
