#pragma once

#include <atomic>
#include <cstddef>
#include <string>
#include <string_view>

#include "process/pool.hpp"

namespace manifuzz {

inline constexpr std::size_t kErrorBytesACase = std::size_t{64} << 10;
inline constexpr std::size_t kErrorBytesARun = std::size_t{1} << 20;

/// Passes on to our standard error what a program writes to its own: so much a case, and so much a
/// run, which all processes that are forked from this one share. Of what is dropped, one line says
/// so once a run.
class ErrorOutput {
 public:
  /// `name` is the program's, in that line.
  explicit ErrorOutput(std::string name) : name_(std::move(name)) { run_->left = kErrorBytesARun; }

  void begin_case() { left_of_case_ = kErrorBytesACase; }
  void pass_on(std::string_view text);

 private:
  struct Run {
    std::atomic<std::size_t> left{0};
    std::atomic<bool> has_said{false};
  };

  std::string name_;
  Shared<Run> run_;
  std::size_t left_of_case_ = kErrorBytesACase;
};

}  // namespace manifuzz
