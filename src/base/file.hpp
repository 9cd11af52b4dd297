#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace manifuzz {

/// The longest line and the largest file that is read as one case, so that no input can take all
/// memory: a case takes about a kilobyte.
inline constexpr std::size_t kLongestCase = 1 << 20;

/// A file open for reading, or the standard input where the path is "-". Throws UserError that
/// names the path.
class InputFile {
 public:
  explicit InputFile(const std::string& path);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  /// Up to `size` bytes, 0 at the end.
  std::size_t read(char* to, std::size_t size);
  /// All that is left, at most `most` bytes: by default what one case may take.
  std::string read_all(std::size_t most = kLongestCase);
  /// As errors name it: the path, or "stdin".
  const std::string& name() const { return name_; }

 private:
  std::string name_;
  int descriptor_;
};

/// Whether there is white space alone.
inline bool is_blank(std::string_view text) {
  return text.find_first_not_of(" \t\r\n") == std::string_view::npos;
}

struct Line {
  std::string_view text;   ///< without its end; valid until the next line is read
  std::size_t number = 0;  ///< counted from 1
  bool too_long = false;   ///< longer than kLongestCase; `text` is then empty

  /// Whether it holds white space alone, and is skipped.
  bool is_blank() const { return !too_long && manifuzz::is_blank(text); }
};

/// The lines of a file, one at a time in constant memory.
class LineReader {
 public:
  /// `before_read` runs before each read, which may block: the place to flush answers.
  explicit LineReader(InputFile& file, std::function<void()> before_read = {});
  /// The next line, or nothing at the end of the file.
  std::optional<Line> next();

 private:
  /// What was read and not handed out yet.
  std::string_view waiting() const { return {buffer_.data() + begin_, end_ - begin_}; }
  /// Reads on behind it; false at the end of the file.
  bool fill();

  InputFile& file_;
  std::function<void()> before_read_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0;  // of `waiting`
  std::size_t end_ = 0;
  std::size_t number_ = 0;
};

/// Writes a file whole or not at all: under a temporary name in the same folder, synced to disk,
/// then renamed over whatever is there. Devices and pipes are written directly. Creates the folder.
/// Throws UserError and leaves no file behind.
void write_file(const std::filesystem::path& path, std::string_view text);

/// The one spelling of all paths to where a file is or would be: absolute, links followed, those to
/// nothing too. "-", a standard stream, stays as it is.
std::filesystem::path resolved(const std::filesystem::path& path);

/// Whether the path is in the folder or below, or the folder itself; neither needs to be there.
bool is_within(const std::filesystem::path& path, const std::filesystem::path& folder);

/// A folder that was empty or not there, and is so again at the end unless it is kept.
class NewFolder {
 public:
  /// Throws UserError that begins with `shown` where anything is there.
  NewFolder(const std::filesystem::path& path, std::string_view shown);
  ~NewFolder();
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  void keep() { is_kept_ = true; }

 private:
  std::filesystem::path path_;
  std::filesystem::path first_new_;  ///< the topmost folder that is not there yet
  bool was_there_ = false;
  bool is_kept_ = false;
};

}  // namespace manifuzz
