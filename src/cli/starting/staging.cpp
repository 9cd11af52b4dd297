#include "cli/starting/staging.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <ranges>
#include <unistd.h>

#include <fmt/format.h>

#include "base/text.hpp"

namespace manifuzz {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_at(const fs::path& path, std::string_view doing, int error) {
  throw UserError(
      fmt::format("{}: cannot {}: {}", printable_path(path), doing, std::strerror(error)));
}

/// Returns 0, or the number of the error; not every file system can do it in one step.
int rename_to_free(const fs::path& from, const fs::path& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return 0;
  if (errno != EINVAL && errno != ENOSYS) return errno;
  std::error_code unknown;
  if (fs::exists(fs::symlink_status(to, unknown))) return EEXIST;
  return ::rename(from.c_str(), to.c_str()) == 0 ? 0 : errno;
}

}  // namespace

Staging::Staging(const fs::path& folder) {
  std::error_code error;
  if (!fs::exists(folder, error)) {
    new_folder_.emplace(fs::absolute(folder), printable_path(folder));
    fs::create_directories(folder, error);
    if (error) fail_at(folder, "create the folder", error.value());
  }
  fs::current_path(folder, error);
  if (error) fail_at(folder, "enter the folder", error.value());
  std::string name = ".manifuzz-XXXXXX";
  if (::mkdtemp(name.data()) == nullptr) fail_at(folder, "write there", errno);
  temporary_ = name;
}

Staging::~Staging() {
  std::error_code unremoved;
  fs::remove_all(temporary_, unremoved);
  for (const fs::path& path : placed_) fs::remove_all(path, unremoved);
  // What somebody else has put into one keeps it.
  for (const fs::path& folder : made_ | std::views::reverse) fs::remove(folder, unremoved);
}

void Staging::place(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const fs::path place(name);
    fs::path folder;
    for (const fs::path& part : place.parent_path()) {
      folder /= part;
      std::error_code error;
      if (fs::create_directory(folder, error)) made_.push_back(folder);
      if (error) fail_at(folder, "create the folder", error.value());
    }
    const int error = rename_to_free(at(name), place);
    if (error != 0) fail_at(place, "write it", error);
    placed_.push_back(place);
  }
  placed_.clear();
  made_.clear();
  if (new_folder_) new_folder_->keep();
}

}  // namespace manifuzz
