#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace manifuzz::canary {

/// A planted bug: one line of one source file changed.
struct Edit {
  std::string bug;        ///< an identifier
  std::string why;        ///< what is wrong, one clause
  std::string file;       ///< from the top of the source tree
  std::string old_line;   ///< without indentation; empty: a copy as it is
  std::string new_lines;  ///< in its place
  int line = 0;           ///< of the table
};

/// The table of planted bugs, a block each:
///
///   bug: what is wrong
///   src/folder/file.hpp
///   -old line
///   +new line             (none or several)
///
/// Blocks end with an empty line; lines that begin with # are comments. Throws std::runtime_error
/// (table, line, what would be right).
std::vector<Edit> read_edits(const std::filesystem::path& table);

/// The file's text with the edit applied. Throws std::runtime_error unless the old line is there
/// exactly once.
std::string edited(const Edit& edit, const std::string& text);

/// A whole file. Throws std::runtime_error.
std::string read_text(const std::filesystem::path& path);

}  // namespace manifuzz::canary
