#include "base/file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include "base/text.hpp"

namespace manifuzz {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kChunk = 1 << 16;

[[noreturn]] void fail(const std::string& name, std::string_view doing, int error) {
  throw UserError(fmt::format("{}: cannot {}: {}", name, doing, std::strerror(error)));
}

/// Returns 0, or the number of the error.
int write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0 && errno != EINTR) return errno;
    if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

/// A new file beside `target`, removed again unless it was renamed to it.
class TemporaryFile {
 public:
  /// Errors name it as `shown`.
  TemporaryFile(const fs::path& target, const std::string& shown)
      : target_(target),
        shown_(shown),
        name_((target.parent_path() / ".manifuzz-XXXXXX").string()) {
    descriptor_ = ::mkstemp(name_.data());
    if (descriptor_ < 0) fail(shown, "create it", errno);
  }
  ~TemporaryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!name_.empty()) ::unlink(name_.c_str());
  }
  TemporaryFile& operator=(TemporaryFile&&) = delete;  // neither moved nor copied

  int descriptor() const { return descriptor_; }

  void rename_to_target() {
    const mode_t mask = ::umask(0);
    ::umask(mask);
    check(::fchmod(descriptor_, 0666 & ~mask) == 0, "set its mode");  // mkstemp's is the owner's
    check(::fsync(descriptor_) == 0, "write it to disk");
    check(::close(std::exchange(descriptor_, -1)) == 0, "close it");
    check(::rename(name_.c_str(), target_.c_str()) == 0, "rename its temporary file");
    name_.clear();
  }

 private:
  void check(bool done, std::string_view doing) const {
    if (!done) fail(shown_, doing, errno);
  }

  fs::path target_;
  std::string shown_;
  std::string name_;
  int descriptor_ = -1;
};

/// Devices and pipes cannot be replaced, and must not be.
void write_device(const fs::path& path, std::string_view text) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) fail(printable_path(path), "open it", errno);
  const int error = write_all(descriptor, text);
  ::close(descriptor);
  if (error != 0) fail(printable_path(path), "write it", error);
}

}  // namespace

std::string printable_path(const fs::path& path) {
  return printable(path.string(), 200);
}

InputFile::InputFile(const std::string& path)
    : name_(path == "-" ? "stdin" : printable_path(path)), descriptor_(STDIN_FILENO) {
  if (path == "-") return;
  descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor_ < 0) fail(name_, "open it", errno);
  struct stat status {};
  if (::fstat(descriptor_, &status) == 0 && S_ISDIR(status.st_mode)) {
    ::close(descriptor_);
    throw UserError(fmt::format("{}: is a folder; a file is expected", name_));
  }
}

InputFile::~InputFile() {
  if (descriptor_ != STDIN_FILENO) ::close(descriptor_);
}

std::size_t InputFile::read(char* to, std::size_t size) {
  ssize_t count = 0;
  do {
    count = ::read(descriptor_, to, size);
  } while (count < 0 && errno == EINTR);
  if (count < 0) fail(name_, "read it", errno);
  return static_cast<std::size_t>(count);
}

std::string InputFile::read_all(std::size_t most) {
  std::string text;
  while (true) {
    const std::size_t had = text.size();
    text.resize(had + kChunk);
    const std::size_t count = read(text.data() + had, kChunk);
    text.resize(had + count);
    if (count == 0) return text;
    if (text.size() > most) {
      throw UserError(
          fmt::format("{}: is larger than {} MiB; that is too much to read", name_, most >> 20));
    }
  }
}

LineReader::LineReader(InputFile& file, std::function<void()> before_read)
    : file_(file), before_read_(std::move(before_read)), buffer_(2 * kChunk) {}

bool LineReader::fill() {
  if (before_read_) before_read_();
  std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_),
            buffer_.begin() + static_cast<std::ptrdiff_t>(end_), buffer_.begin());
  end_ -= begin_;
  begin_ = 0;
  if (buffer_.size() < end_ + kChunk) buffer_.resize(2 * buffer_.size());
  const std::size_t count = file_.read(buffer_.data() + end_, kChunk);
  end_ += count;
  return count > 0;
}

std::optional<Line> LineReader::next() {
  auto line = next_of_all();
  while (line && !line->too_long && is_blank(line->text)) line = next_of_all();
  return line;
}

std::optional<Line> LineReader::next_of_all() {
  Line line{{}, ++number_, false};
  std::size_t searched = 0;
  do {
    const std::string_view text = waiting();
    const std::size_t length = text.find('\n', searched);
    if (length != std::string_view::npos) {
      begin_ += length + 1;
      line.too_long = line.too_long || length > kLongestCase;
      if (!line.too_long) line.text = text.substr(0, length);
      return line;
    }
    searched = text.size();
    if (searched > kLongestCase) {
      line.too_long = true;
      begin_ = end_;
      searched = 0;
    }
  } while (fill());
  if (!line.too_long) line.text = waiting();  // the last line may lack its end
  begin_ = end_;
  if (line.text.empty() && !line.too_long) return std::nullopt;
  return line;
}

void write_file(const fs::path& path, std::string_view text) {
  std::error_code unknown;
  const fs::file_status status = fs::status(path, unknown);
  if (fs::is_directory(status)) {
    throw UserError(fmt::format("{}: is a folder; a file is expected", printable_path(path)));
  }
  if (fs::exists(status) && !fs::is_regular_file(status)) return write_device(path, text);
  // A link stays, and what it points to is replaced.
  const bool is_dangling = !fs::exists(status) && fs::is_symlink(fs::symlink_status(path, unknown));
  if (is_dangling) throw UserError(fmt::format("{}: is a link to nothing", printable_path(path)));
  const fs::path target = fs::exists(status) ? fs::canonical(path) : path;
  if (target.has_parent_path()) {
    std::error_code not_created;
    fs::create_directories(target.parent_path(), not_created);
    if (not_created)
      fail(printable_path(target.parent_path()), "create the folder", not_created.value());
  }
  TemporaryFile temporary(target, printable_path(path));
  const int error = write_all(temporary.descriptor(), text);
  if (error != 0) fail(printable_path(path), "write it", error);
  temporary.rename_to_target();
}

fs::path resolved(const fs::path& path) {
  constexpr int links_max = 40;
  if (path == "-") return path;
  std::error_code unknown;
  fs::path place = fs::absolute(path, unknown);
  for (int i = 0; i < links_max && fs::is_symlink(place, unknown); ++i) {
    place = place.parent_path() / fs::read_symlink(place, unknown);
  }
  const fs::path canonical = fs::weakly_canonical(place, unknown);
  return canonical.empty() ? fs::absolute(path, unknown) : canonical;  // links may lead in a circle
}

bool is_within(const fs::path& path, const fs::path& folder) {
  const fs::path way = resolved(path).lexically_relative(resolved(folder));
  return !way.empty() && *way.begin() != "..";
}

NewFolder::NewFolder(const fs::path& path, std::string_view shown) : path_(path), first_new_(path) {
  std::error_code unreadable;
  was_there_ = fs::exists(fs::symlink_status(path, unreadable));
  if (was_there_ && !(fs::is_directory(path, unreadable) && fs::is_empty(path, unreadable))) {
    throw UserError(
        fmt::format("{} is there already; a new or an empty folder is expected", shown));
  }
  while (first_new_.has_parent_path() && !fs::exists(first_new_.parent_path(), unreadable)) {
    first_new_ = first_new_.parent_path();
  }
}

NewFolder::~NewFolder() {
  if (is_kept_) return;
  std::error_code unremoved;
  if (!was_there_) {
    fs::remove_all(first_new_, unremoved);
    return;
  }
  for (const auto& entry : fs::directory_iterator(path_, unremoved)) {
    fs::remove_all(entry.path(), unremoved);
  }
}

void write_error(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
}

void Output::write(std::string_view text) {
  constexpr std::size_t enough = 1 << 16;
  buffer_ += text;
  if (buffer_.size() >= enough) flush();
}

void Output::flush() {
  const int error = write_all(STDOUT_FILENO, buffer_);
  if (error == EPIPE) throw OutputClosed();
  if (error != 0) fail("stdout", "write it", error);
  buffer_.clear();
}

void write_output(std::string_view text) {
  Output out;
  out.write(text);
  out.flush();
}

void write_to_reader(std::string_view text) {
  try {
    write_output(text);
  } catch (const OutputClosed&) {
  }
}

void write_data(const std::string& file, std::string_view text) {
  file == "-" ? write_to_reader(text) : write_file(file, text);
}

}  // namespace manifuzz
