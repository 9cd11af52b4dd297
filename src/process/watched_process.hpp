#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <sys/types.h>

namespace manifuzz {

/// A child process at work, which has hung where its pulse stands still for too long.
class WatchedProcess {
 public:
  enum class State { working, done, crashed, hung };

  /// Runs `body` in a child process, as `spawn` does.
  void start(const std::function<void()>& body);
  /// How it is doing: any number that moves while it works is its pulse. One that is not working is
  /// ended and waited for.
  State look(std::uint64_t pulse, double seconds_max);
  void kill();

  bool alive() const { return process_ > 0; }

 private:
  using Clock = std::chrono::steady_clock;

  pid_t process_ = 0;
  std::uint64_t seen_ = 0;
  Clock::time_point seen_at_;
};

}  // namespace manifuzz
