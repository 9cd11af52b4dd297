#include "process/signals.hpp"

#include <limits>

#include "process/interruption.hpp"

namespace manifuzz {
namespace {

int taken = 0;
int first_taken = 0;
Clock::time_point first_taken_at{};
double seconds_to_leave = std::numeric_limits<double>::infinity();

bool is_ignored(int signal) {
  struct sigaction now {};
  return sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

sigset_t set_of_ending_signals() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  if (!is_ignored(SIGHUP)) sigaddset(&set, SIGHUP);
  return set;
}

}  // namespace

const sigset_t& ending_signals() {
  static const sigset_t set = set_of_ending_signals();
  return set;
}

void take_ending_signals() {
  const timespec at_once{0, 0};
  for (int signal = 0; (signal = sigtimedwait(&ending_signals(), nullptr, &at_once)) > 0;) {
    count_ending_signal(signal);
  }
}

void count_ending_signal(int signal) {
  if (taken++ > 0) return;
  first_taken = signal;
  first_taken_at = Clock::now();
}

int ending_signals_taken() {
  return taken;
}

void leave_after_signal(double seconds) {
  seconds_to_leave = seconds;
}

bool is_out_of_time(double share) {
  take_ending_signals();
  return taken > 0 && seconds_since(first_taken_at) >= share * seconds_to_leave;
}

EndingSignalsLetThrough::EndingSignalsLetThrough() {
  sigprocmask(SIG_UNBLOCK, &ending_signals(), &mask_before_);
}

EndingSignalsLetThrough::~EndingSignalsLetThrough() {
  sigprocmask(SIG_SETMASK, &mask_before_, nullptr);
}

int status_of_signal(int signal) {
  return 128 + (signal == SIGINT ? SIGINT : SIGTERM);
}

int status_after_signals(int status) {
  take_ending_signals();
  return taken == 0 || status == 1 ? status : status_of_signal(first_taken);
}

}  // namespace manifuzz
