#include "process/interruption.hpp"

#include <algorithm>

#include "process/signals.hpp"

namespace manifuzz {
namespace {

/// The signals by which this program is to end, and the one that says that a child has ended.
sigset_t held_signals() {
  sigset_t held = ending_signals();
  sigaddset(&held, SIGCHLD);
  return held;
}

double seconds_until(const Deadline& deadline, double most) {
  if (!deadline || has_passed(deadline)) return most;
  return std::min(most, std::chrono::duration<double>(*deadline - Clock::now()).count());
}

}  // namespace

Interruption::Interruption(const Limits& limits) : limits_(limits) {
  const sigset_t held = held_signals();
  sigprocmask(SIG_BLOCK, &held, &mask_before_);
  take_ending_signals();  // those belong to whoever held them back
  signals_before_ = ending_signals_taken();
}

Interruption::~Interruption() {
  take_ending_signals();  // lest they strike when the mask is lifted
  sigprocmask(SIG_SETMASK, &mask_before_, nullptr);
}

int Interruption::signals() const {
  take_ending_signals();
  return ending_signals_taken() - signals_before_;
}

Interruption::State Interruption::state() {
  const int count = signals();
  if (has_passed(limits_.stopped_at) || count > 1 || is_out_of_time(limits_.share)) {
    return State::stopped;
  }
  if (count == 0) return has_passed(limits_.hurried_at) ? State::hurried : limits_.begins;
  return limits_.begins == State::hurried ? State::stopped : limits_.first_signal;
}

bool Interruption::is_called_off() {
  return limits_.begins == State::stopped || signals() > (limits_.begins == State::running ? 1 : 0);
}

void Interruption::wait(double seconds) {
  using namespace std::chrono;
  seconds = seconds_until(limits_.hurried_at, seconds_until(limits_.stopped_at, seconds));
  const auto time = ceil<nanoseconds>(duration<double>(std::max(0.0, seconds)));
  const auto whole = floor<std::chrono::seconds>(time);
  const timespec timeout{whole.count(), (time - whole).count()};
  const sigset_t held = held_signals();
  const int signal = sigtimedwait(&held, nullptr, &timeout);
  if (signal > 0 && signal != SIGCHLD) count_ending_signal(signal);
}

}  // namespace manifuzz
