#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

#include "exchange/reported_manifold.hpp"
#include "process/child.hpp"

namespace manifuzz {

/// How long a program may take.
struct TimeLimits {
  double start_seconds = 0;  ///< for the first answer of a process
  double case_seconds = 0;   ///< for each one after
};

/// How a batch of cases ended.
enum class BatchEnd {
  answered,     ///< every case has its answer
  stopped,      ///< we did not want to go on
  exited,       ///< its output ended
  timed_out,    ///< no answer in time
  not_json,     ///< a line that is not JSON: what follows may answer another case
  extra_lines,  ///< more lines than cases
};

struct BatchResult {
  std::size_t answered = 0;  ///< of the cases, in order
  BatchEnd end = BatchEnd::answered;
  std::string why;
};

/// A program that reads pair cases, a line each, on its standard input, and writes a manifold line
/// for each to its standard output, in order. Before its first answer it may write its declaration.
/// An answer that is JSON but no manifold is `Lost`, and its case's alone.
class ProgramProcess {
 public:
  ProgramProcess(std::string command, const TimeLimits& time_limits)
      : limits(time_limits), command_(std::move(command)) {}

  TimeLimits limits;
  Conventions conventions;  ///< of its answers, as it declares them

  /// Asks all at once, and reads while it writes; starts the program where it does not run. `go_on`
  /// is asked several times a second.
  BatchResult ask(std::span<const PairCase> pairs, std::span<Answer> answers,
                  const std::function<bool()>& go_on);

  /// Whether it writes more than it was asked for, within that time.
  bool writes_more(double seconds);

  /// Ends the program. Says how it had ended, if it had by itself.
  std::string stop();

  /// The declaration of the last start, a line of JSON, or empty.
  const std::string& declaration() const { return declaration_; }

 private:
  using Clock = std::chrono::steady_clock;

  void start();
  void write_some(std::string_view& text);
  bool read_some();
  bool is_next_line(std::string& line);
  void take_lines(std::span<const PairCase> pairs, std::span<Answer> answers, BatchResult& result);

  std::string command_;
  Child child_;
  std::string unread_;
  std::string declaration_;
  bool has_answered_ = false;  ///< since it was started
};

}  // namespace manifuzz
