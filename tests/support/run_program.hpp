#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace manifuzz::test {

/// How a program ended and what it wrote.
struct Outcome {
  int status = 0;  ///< the exit status, or 128 + the signal that ended it
  std::string out;
  std::string err;
};

/// Runs a command (looked up in PATH unless it has a slash) with `input` on its standard input, in
/// this environment but for what a GitHub workflow sets.
Outcome run_program(const std::vector<std::string>& command, std::string_view input = {});

/// Runs a command on a terminal of its own; `out` is all that it shows, of either stream.
Outcome run_on_terminal(const std::vector<std::string>& command);

/// Runs the built manifuzz.
Outcome run_manifuzz(const std::vector<std::string>& arguments, std::string_view input = {});

/// The path of the built manifuzz.
std::string manifuzz_path();

/// A command with more arguments.
std::vector<std::string> with(std::vector<std::string> command,
                              const std::vector<std::string>& more);

/// The lines of a text; each must have its end.
std::vector<std::string> lines_of(std::string_view text);

/// Whether `text` is one line of printable ASCII with its end: what an error looks like.
bool is_one_clear_line(std::string_view text);

}  // namespace manifuzz::test
