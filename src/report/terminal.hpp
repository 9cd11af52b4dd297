#pragma once

#include <string>
#include <string_view>
#include <vector>

// Colours, and what a person at a terminal is told beside the results.

namespace manifuzz {

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

}  // namespace manifuzz
