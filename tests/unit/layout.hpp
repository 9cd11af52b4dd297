#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace manifuzz::test {

/// A file of the tree: its path from the top ("src/geometry/pose.hpp") and its text.
struct SourceFile {
  std::string path;
  std::string text;
};

/// What breaks a rule of the layout, a line each: the file, and what would be right.
using Violations = std::vector<std::string>;

/// The engine that an engine descends from, and may include; empty for none.
std::string_view ancestor_of(std::string_view engine);

/// Which folders the includes of each folder point to, a line each, in the layout's order.
std::string drawing_of_arrows(const std::vector<SourceFile>& files);

/// Includes that point to a folder further down the list, or to one that is hidden.
Violations forbidden_includes(const std::vector<SourceFile>& files);

/// Source files (src, oracle, tests, scripts) of more than 300 lines.
Violations long_files(const std::vector<SourceFile>& files);

/// Folders of src and oracle with more than 24 modules; a header and its source are one.
Violations crowded_folders(const std::vector<SourceFile>& files);

/// Files whose top-level entry the layout does not name.
Violations stray_entries(const std::vector<SourceFile>& files);

/// Paths that exist on one machine only.
Violations machine_paths(const std::vector<SourceFile>& files);

}  // namespace manifuzz::test
