#include "process/interruption.hpp"

#include <algorithm>

namespace manifuzz {
namespace {

/// How many signals this process has taken, whichever Interruption took them.
int signals_taken = 0;

sigset_t set_of(std::initializer_list<int> signals) {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : signals) sigaddset(&set, signal);
  return set;
}

const sigset_t kStopping = set_of({SIGINT, SIGTERM});
const sigset_t kHeld = set_of({SIGINT, SIGTERM, SIGCHLD});

void take_pending() {
  const timespec at_once{0, 0};
  while (sigtimedwait(&kStopping, nullptr, &at_once) > 0) ++signals_taken;
}

double seconds_until(const Deadline& deadline, double most) {
  if (!deadline || has_passed(deadline)) return most;
  return std::min(most, std::chrono::duration<double>(*deadline - Clock::now()).count());
}

}  // namespace

Interruption::Interruption(const Limits& limits) : limits_(limits) {
  sigprocmask(SIG_BLOCK, &kHeld, &mask_before_);
  take_pending();  // those belong to whoever held them back
  signals_before_ = signals_taken;
}

Interruption::~Interruption() {
  take_pending();  // lest they strike when the mask is lifted
  sigprocmask(SIG_SETMASK, &mask_before_, nullptr);
}

Interruption::State Interruption::state() {
  take_pending();
  const int signals = signals_taken - signals_before_;
  if (has_passed(limits_.stopped_at) || signals > 1) return State::stopped;
  if (signals == 0) return has_passed(limits_.hurried_at) ? State::hurried : limits_.begins;
  return limits_.begins == State::hurried ? State::stopped : limits_.first_signal;
}

void Interruption::wait(double seconds) {
  using namespace std::chrono;
  seconds = seconds_until(limits_.hurried_at, seconds_until(limits_.stopped_at, seconds));
  const auto time = ceil<nanoseconds>(duration<double>(std::max(0.0, seconds)));
  const auto whole = floor<std::chrono::seconds>(time);
  const timespec timeout{whole.count(), (time - whole).count()};
  const int signal = sigtimedwait(&kHeld, nullptr, &timeout);
  if (signal == SIGINT || signal == SIGTERM) ++signals_taken;
}

}  // namespace manifuzz
