#include <cerrno>
#include <cstring>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

#include "base/file.hpp"
#include "base/new_file.hpp"
#include "base/text.hpp"

namespace manifuzz {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTemporaryName = ".manifuzz-XXXXXX";

std::string failure(const std::string& doing) {
  return "cannot " + doing + ": " + std::strerror(errno);
}

/// A folder that is made, its parents too, and taken away again.
class TrialFolder {
 public:
  explicit TrialFolder(const fs::path& folder) {
    std::vector<fs::path> missing;
    fs::path next = folder;
    while (!next.empty() && ::access(next.c_str(), F_OK) != 0 && errno != EACCES) {
      missing.push_back(next);
      next = next.parent_path();
    }
    for (; why_not_.empty() && !missing.empty(); missing.pop_back()) {
      if (::mkdir(missing.back().c_str(), 0777) == 0) {
        made_.push_back(missing.back());
      } else if (errno != EEXIST) {
        why_not_ = failure("create the folder");
      }
    }
  }
  ~TrialFolder() {
    for (; !made_.empty(); made_.pop_back()) ::rmdir(made_.back().c_str());
  }
  TrialFolder& operator=(TrialFolder&&) = delete;  // neither moved nor copied

  const std::string& why_not() const { return why_not_; }

 private:
  std::vector<fs::path> made_;
  std::string why_not_;
};

std::string why_no_temporary_file_in(const fs::path& folder) {
  std::string path = folder / kTemporaryName;
  const int file = ::mkstemp(path.data());
  if (file < 0) return failure("create it");
  ::close(file);
  ::unlink(path.c_str());
  return "";
}

}  // namespace

Place::Place(const fs::path& given) : path(resolved(given)) {
  struct stat status {};
  if (::stat(path.c_str(), &status) == 0) file.emplace(status.st_dev, status.st_ino);
}

bool Place::is_same(const Place& other) const {
  return path == other.path || (file && file == other.file);
}

bool Place::is_within(const Place& folder) const {
  return is_same(folder) || manifuzz::is_within(path, folder.path);
}

std::string why_not_writable(const fs::path& file) {
  std::error_code unknown;
  const fs::file_status status = fs::status(file, unknown);
  if (fs::is_directory(status)) return "is a folder; a file is expected";
  if (fs::is_regular_file(status)) return why_no_temporary_file_in(resolved(file).parent_path());
  if (fs::exists(status)) return ::access(file.c_str(), W_OK) == 0 ? "" : failure("open it");
  if (fs::is_symlink(fs::symlink_status(file, unknown))) return "is a link to nothing";
  const TrialFolder folder(file.parent_path());
  if (!folder.why_not().empty()) return folder.why_not();
  if (!make_new_file(file)) return failure("create it");
  ::unlink(file.c_str());
  return "";
}

std::string why_no_folder(const fs::path& folder) {
  std::error_code unknown;
  if (fs::exists(folder, unknown) && !fs::is_directory(folder, unknown)) return "is no folder";
  const TrialFolder made(folder);
  return made.why_not().empty() ? why_no_temporary_file_in(folder) : made.why_not();
}

fs::path kept_path(const fs::path& path) {
  std::error_code unknown;
  const fs::path kept = fs::proximate(path, unknown);
  return unknown || kept.empty() ? path : kept;
}

std::string this_program() {
  std::error_code unknown;
  fs::path self = fs::read_symlink("/proc/self/exe", unknown);
  if (unknown) return "manifuzz";
  if (self.filename() == kMeasuringProgram) self.replace_filename("manifuzz");
  return quoted_for_shell(fs::relative(self, unknown).string());
}

}  // namespace manifuzz
