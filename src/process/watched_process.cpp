#include "process/watched_process.hpp"

#include <sys/wait.h>

#include "process/process.hpp"

namespace manifuzz {

void WatchedProcess::start(const std::function<void()>& body) {
  seen_at_ = Clock::now();
  process_ = spawn(body);
}

WatchedProcess::State WatchedProcess::look(std::uint64_t pulse, double seconds_max) {
  if (!alive()) return State::done;
  if (pulse != seen_) {
    seen_ = pulse;
    seen_at_ = Clock::now();
  } else if (std::chrono::duration<double>(Clock::now() - seen_at_).count() > seconds_max) {
    kill();
    return State::hung;
  }
  int status = 0;
  if (waitpid(process_, &status, WNOHANG) != process_) return State::working;
  process_ = 0;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? State::done : State::crashed;
}

void WatchedProcess::kill() {
  if (alive()) kill_and_wait(process_);
  process_ = 0;
}

}  // namespace manifuzz
