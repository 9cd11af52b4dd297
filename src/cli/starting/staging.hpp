#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/file.hpp"

namespace manifuzz {

/// What is written for a folder, which becomes the working folder: first in a temporary folder in
/// it, then each at its place, all of it or nothing. Nothing that is there is replaced.
class Staging {
 public:
  /// Throws UserError where the folder cannot be written to; one that is missing is made.
  explicit Staging(const std::filesystem::path& folder);
  ~Staging();
  Staging& operator=(Staging&&) = delete;  // neither moved nor copied

  /// Where something is before it is placed, from the working folder.
  std::filesystem::path at(const std::string& name) const { return temporary_ / name; }
  /// Puts these at their places. Throws UserError, and then none of them is there.
  void place(const std::vector<std::string>& names);

 private:
  std::optional<NewFolder> new_folder_;
  std::filesystem::path temporary_;
  std::vector<std::filesystem::path> placed_;
  std::vector<std::filesystem::path> made_;  ///< folders for what is placed
};

}  // namespace manifuzz
