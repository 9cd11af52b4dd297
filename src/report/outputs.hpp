#pragma once

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "base/file.hpp"

namespace manifuzz {

// Colours, and what a person at a terminal is told beside the results.

/// Whether that stream (STDOUT_FILENO, STDERR_FILENO) is a terminal that can colour and erase; one
/// without a name or named `dumb` cannot.
bool is_able_terminal(int stream);

/// From now on words are coloured on each stream that is an able terminal, unless the environment
/// names NO_COLOR. Before, nowhere: text that is built for a file or a test is plain.
void allow_colours();

/// A word for stdout, its spaces included: what is well, what decides a status, what is new.
std::string good(std::string_view word);
std::string bad(std::string_view word);
std::string fresh(std::string_view word);

/// The same for what is wrong, on stderr.
std::string bad_on_stderr(std::string_view word);

/// What is wrong, a line on the standard error: "manifuzz: what".
void write_complaint(std::string_view what);
void write_complaints(const std::vector<std::string>& all);

/// From now on nothing but data, what is wrong, and what decides a status.
void be_quiet();
bool is_quiet();

/// A line on the standard error that nothing depends on; none when quiet.
void write_remark(std::string_view line);

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

/// Whether tables are left out: when quiet, where one of these files (empty: none, "-": stdout)
/// takes what they say.
bool leaves_out_tables(std::initializer_list<std::string_view> files);

/// JSON as it is written for people and programs: indented, with a line's end. Paths need not be
/// UTF-8; what is not is replaced.
std::string json_text(const nlohmann::ordered_json& json);

/// Outputs that are written one by one: one that fails is named, once, and no other is lost by
/// that.
class Outputs {
 public:
  /// Runs what writes an output, if it is asked for; it may throw a UserError.
  void write(bool is_asked, const std::function<void()>& write_it);
  /// What went wrong beside the writing, if anything did.
  void add_error(const std::string& what);

  bool are_written() const { return errors_.empty(); }
  const std::vector<std::string>& errors() const { return errors_; }

 private:
  std::vector<std::string> errors_;
};

/// Whether the collider of that name is there on any machine.
using IsAtHand = std::function<bool(const std::string& collider)>;

/// What somebody new can do next, in about a dozen lines: commands that work when pasted where they
/// are, and a case of `corpus` to look at, where there is such a folder. `program` is this one as
/// it was called.
std::string next_steps(const std::string& program, const std::string& corpus,
                       const IsAtHand& is_at_hand);

}  // namespace manifuzz
