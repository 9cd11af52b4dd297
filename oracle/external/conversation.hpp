#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

#include "collider/collider.hpp"
#include "process/child.hpp"

namespace manifuzz {

/// How a program's lines say what the contract leaves open; declared once, converted here.
struct Dialect {
  bool has_midpoints = false;
  bool normal_from_b = false;  ///< normals point from B to A
};

/// How long a program may take.
struct Patience {
  double start_seconds = 0;  ///< for the first answer of a process
  double case_seconds = 0;   ///< for each one after
};

/// A program that reads pair cases, a line each, on its standard input, and writes a manifold line
/// for each to its standard output, in order. Before its first answer it may write its declaration.
class Conversation {
 public:
  explicit Conversation(std::string command) : command_(std::move(command)) {}

  enum class End {
    done,         ///< every case has its answer
    stopped,      ///< we did not want to go on
    died,         ///< its output ended
    silent,       ///< no answer in time
    not_json,     ///< a line that is not JSON: what follows may answer another case
    extra_lines,  ///< more lines than cases
  };
  struct Talk {
    std::size_t answered = 0;
    End end = End::done;
    std::string why;
  };

  /// Asks all at once, and reads while it writes; starts the program where it does not run.
  Talk ask(std::span<const PairCase> pairs, std::span<Answer> answers, const Dialect& dialect,
           const Patience& patience, const std::function<bool()>& go_on);

  /// Whether it says more than it was asked for, within that time.
  bool says_more(double seconds);

  /// Ends the program. Says how it had ended, if it had by itself.
  std::string stop();

  /// The declaration line of the last start, or empty.
  const std::string& declared() const { return declared_; }

 private:
  using Clock = std::chrono::steady_clock;

  void start();
  void write_some(std::string_view& text);
  bool read_some();
  bool is_next_line(std::string& line);
  void take_lines(std::span<const PairCase> pairs, std::span<Answer> answers,
                  const Dialect& dialect, Talk& talk);

  std::string command_;
  Child child_;
  std::string unread_;
  std::string declared_;
  bool has_answered_ = false;  ///< since it was started
};

}  // namespace manifuzz
