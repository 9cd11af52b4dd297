#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <sys/types.h>
#include <utility>
#include <vector>

namespace manifuzz {

/// The longest line and the largest file that is read as one case, so that no input can take all
/// memory: a case takes about a kilobyte.
inline constexpr std::size_t kLongestCase = 1 << 20;

/// A path as errors name it: printable, and not too long.
std::string printable_path(const std::filesystem::path& path);

/// A file open for reading, or the standard input where the path is "-". Throws UserError that
/// names the path.
class InputFile {
 public:
  explicit InputFile(const std::string& path);
  ~InputFile();
  InputFile& operator=(InputFile&&) = delete;  // neither moved nor copied

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
};

/// The lines of a file that are not blank, one at a time in constant memory.
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
  /// The next line, a blank one too.
  std::optional<Line> next_of_all();

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
  NewFolder& operator=(NewFolder&&) = delete;  // neither moved nor copied

  const std::filesystem::path& path() const { return path_; }
  void keep() { is_kept_ = true; }

 private:
  std::filesystem::path path_;
  std::filesystem::path first_new_;  ///< the topmost folder that is not there yet
  bool was_there_ = false;
  bool is_kept_ = false;
};

/// Writes to the standard error as far as it goes: one that is closed or full stops nothing.
void write_error(std::string_view text);

/// Thrown where nobody reads the output any more: the command ends, quietly.
struct OutputClosed {};

/// The standard output, buffered. Throws UserError where it cannot be written (a full disk), and
/// OutputClosed where its reader is gone. What is not flushed is lost.
class Output {
 public:
  void write(std::string_view text);
  void flush();

 private:
  std::string buffer_;
};

/// Writes all of it to the standard output, as `Output` does.
void write_output(std::string_view text);

/// The same, but a reader that is gone stops nothing: what a command says is in its status too.
void write_to_reader(std::string_view text);

/// Writes to the file of that name, or to the standard output for "-".
void write_data(const std::string& file, std::string_view text);

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

/// The program beside manifuzz that has those of its commands that measure and hunt.
inline constexpr std::string_view kMeasuringProgram = "manifuzz-measure";

/// This program as it can be called again, relative to the working folder, so that a kept output
/// holds no absolute path; for a shell.
std::string this_program();

}  // namespace manifuzz
