#pragma once

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <optional>

namespace manifuzz {

using Clock = std::chrono::steady_clock;
inline double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A moment by which work must be done; none: it may take as long as it takes.
using Deadline = std::optional<Clock::time_point>;
inline bool has_passed(const Deadline& deadline) {
  return deadline && Clock::now() >= *deadline;
}
/// So many seconds from now, thirty years at most.
inline Clock::time_point after(double seconds) {
  constexpr double thirty_years = 1e9;
  const std::chrono::duration<double> time(std::min(seconds, thirty_years));
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(time);
}
/// The one that comes first.
inline Deadline earlier(const Deadline& a, const Deadline& b) {
  return a && b ? std::min(*a, *b) : a ? a : b;
}
/// When the first of so many, who share what time is left, must be done.
inline Deadline share_of(const Deadline& deadline, std::size_t count) {
  if (!deadline) return deadline;
  const auto now = Clock::now();
  return now + (*deadline - now) / static_cast<int>(count);
}

/// Holds SIGINT, SIGTERM and SIGHUP back for as long as it lives, so that work can end in good
/// order. One that lives around another counts its signals too. All are stopped once the time is
/// over that the first signal leaves.
class Interruption {
 public:
  enum class State {
    running,
    hurried,  ///< what is under way ends fast, and what was found is saved
    stopped,  ///< nothing goes on
  };
  struct Limits {
    State begins = State::running;
    State first_signal = State::hurried;  ///< what that leads to; another one stops
    Deadline hurried_at{};
    Deadline stopped_at{};
    double share = 1;  ///< of the time that the first signal leaves: then this is stopped
  };

  Interruption() : Interruption(Limits{}) {}
  explicit Interruption(const Limits& limits);
  ~Interruption();
  Interruption& operator=(Interruption&&) = delete;  // neither moved nor copied

  State state();
  bool is_stopped() { return state() == State::stopped; }
  /// Whether somebody asked again: then nothing is to be finished, whatever time there is.
  bool is_called_off();
  /// Whether anybody has asked, since this one lives or before.
  bool is_signalled() { return limits_.begins != State::running || signals() > 0; }
  /// Waits until a signal, a child's end or a deadline, at most so long.
  void wait(double seconds);

  /// Limits for a part of this work that a signal must stop at once, as this one's deadline does.
  Limits until_signal() const {
    return {.first_signal = State::stopped, .stopped_at = limits_.stopped_at};
  }

 private:
  int signals() const;

  Limits limits_;
  sigset_t mask_before_;
  int signals_before_;  ///< taken by others before this one lived
};

/// Limits for work that leaves nothing to be saved: the first signal stops it.
inline constexpr Interruption::Limits kUntilSignal{.first_signal = Interruption::State::stopped};

}  // namespace manifuzz
