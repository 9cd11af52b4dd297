#pragma once

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "base/user_error.hpp"

namespace manifuzz {

/// Writes to the standard error as far as it goes: one that is closed or full stops nothing.
void write_error(std::string_view text);

/// What is wrong, a line on the standard error: "manifuzz: what".
void write_complaint(std::string_view what);
void write_complaints(const std::vector<std::string>& all);

/// The path from the working folder, since no absolute path goes into what is kept; as it is where
/// that cannot be told.
std::filesystem::path kept_path(const std::filesystem::path& path);

/// From now on nothing but data, what is wrong, and what decides a status.
void be_quiet();
bool is_quiet();

/// Whether tables are left out: when quiet, where one of these files (empty: none, "-": stdout)
/// takes what they say.
bool leaves_out_tables(std::initializer_list<std::string_view> files);

/// A line on the standard error that nothing depends on; none when quiet.
void write_remark(std::string_view line);

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

/// Writes all of it to the standard output; a reader that is gone stops nothing, for what a command
/// has to say is in its status too.
void write_to_reader(std::string_view text);

/// What is wrong with an output itself, so that nothing may be written there.
struct BadOutput : UserError {
  using UserError::UserError;
};

/// An option, and the file that it names for data: "-" is the standard output, "" is none.
struct DataFile {
  std::string_view option;
  std::string_view file;
};

/// Whether one of them takes the standard output, which then has nothing else. Throws BadOutput
/// where two would write to one place.
bool takes_stdout(std::initializer_list<DataFile> files);

/// Throws BadOutput where one of them is among `inputs`: what was there before is not lost.
void expect_apart(std::initializer_list<DataFile> outputs,
                  std::span<const std::filesystem::path> inputs);

/// Throws BadOutput where one of them would be taken for a case of this folder, or be overwritten
/// by one.
void expect_outside(std::initializer_list<DataFile> outputs, const std::filesystem::path& folder);

/// Writes to the file of that name, or to the standard output for "-".
void write_data(const std::string& file, std::string_view text);

/// JSON as it is written for people and programs: indented, with a line's end. Paths need not be
/// UTF-8; what is not is replaced.
std::string json_text(const nlohmann::ordered_json& json);

/// Outputs that are written one by one: one that fails is named, once, and no other is lost by
/// that.
class Outputs {
 public:
  /// Runs what writes an output, if it is asked for; it may throw a UserError.
  void write(bool is_asked, const std::function<void()>& write_it);

  bool are_written() const { return errors_.empty(); }
  const std::vector<std::string>& errors() const { return errors_; }

 private:
  std::vector<std::string> errors_;
};

/// One line on a terminal, written over and over; nothing when quiet, and where stderr is no
/// terminal that could erase it.
class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(std::string_view text) const;

 private:
  bool is_shown_;
};

}  // namespace manifuzz
