#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <sys/types.h>
#include <utility>

namespace manifuzz {

/// The file or folder that a path means, the same for every spelling of it and every link to it.
struct Place {
  std::filesystem::path path;  ///< absolute, links followed, even those to nothing
  std::optional<std::pair<dev_t, ino_t>> file{};  ///< none: it is not there yet

  explicit Place(const std::filesystem::path& given);

  bool is_same(const Place& other) const;
  /// Whether this is the folder itself, or anything below it.
  bool is_within(const Place& folder) const;
};

/// Why no file could be written there by `write_file`, or nothing: what is missing is made and
/// taken away again.
std::string why_not_writable(const std::filesystem::path& file);

/// Why no file could be written below this folder, or nothing; the folder is made and taken away
/// again where it is missing.
std::string why_no_folder(const std::filesystem::path& folder);

/// The path from the working folder, since no absolute path goes into what is kept; as it is where
/// that cannot be told.
std::filesystem::path kept_path(const std::filesystem::path& path);

/// This program as it can be called again, relative to the working folder, so that a kept output
/// holds no absolute path; for a shell.
std::string this_program();

}  // namespace manifuzz
