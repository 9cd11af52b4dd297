#include "process/child.hpp"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <poll.h>
#include <string_view>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>

#include "process/interruption.hpp"
#include "process/signals.hpp"

namespace manifuzz {
namespace {

struct Pipe {
  std::array<int, 2> ends{-1, -1};

  Pipe() {
    if (pipe2(ends.data(), O_CLOEXEC) != 0) {
      throw std::system_error(errno, std::generic_category(), "cannot open a pipe");
    }
  }
  ~Pipe() {
    for (const int end : ends) {
      if (end >= 0) close(end);
    }
  }
  Pipe& operator=(Pipe&&) = delete;  // neither moved nor copied

  int release(int end) { return std::exchange(ends[static_cast<std::size_t>(end)], -1); }
};

int unblocked(int descriptor) {
  fcntl(descriptor, F_SETFL, fcntl(descriptor, F_GETFL) | O_NONBLOCK);
  return descriptor;
}

/// What a process may not inherit from one that holds signals back, ignores or handles them.
void reset_signals() {
  for (const int signal : {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGPIPE, SIGSEGV}) {
    std::signal(signal, SIG_DFL);
  }
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    if (sigismember(&ending_signals(), signal) == 1) std::signal(signal, SIG_DFL);
  }
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
}

/// The process groups that run: those that do not fit are left to `Descendants`.
std::array<std::atomic<pid_t>, 64> running_groups{};

void replace_group(pid_t before, pid_t after) {
  for (auto& group : running_groups) {
    pid_t expected = before;
    if (group.compare_exchange_strong(expected, after)) return;
  }
}

extern "C" void die_with_children(int signal) {
  for (const auto& group : running_groups) {
    if (group > 0) kill(-group, SIGKILL);
  }
  constexpr std::string_view words = "manifuzz: interrupted before it was done\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, words.data(), words.size());
  _exit(status_of_signal(signal));
}

bool is_writing_core(pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("CoreDumping:")) return line.ends_with('1');
  }
  return false;
}

/// Ends a group's leader, in whichever group it is by now. One that the system does not let end is
/// left behind: nobody waits for it.
void end_leader(pid_t leader) {
  constexpr double seconds_max = 1;
  kill(leader, SIGKILL);
  const Clock::time_point began = Clock::now();
  while (waitpid(leader, nullptr, WNOHANG) == 0 && seconds_since(began) < seconds_max) {
    usleep(200);
  }
}

constexpr int kLeftHalfway = 3;

void leave_halfway() {
  _exit(kLeftHalfway);
}

std::string obituary(int status) {
  if (WIFSIGNALED(status)) {
    return fmt::format("was killed by signal {} ({})", WTERMSIG(status),
                       strsignal(WTERMSIG(status)));
  }
  return fmt::format("exited with status {}", WEXITSTATUS(status));
}

}  // namespace

pid_t spawn(const std::function<void()>& body) {
  std::fflush(nullptr);
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child < 0) {
    throw std::system_error(errno, std::generic_category(),
                            "cannot start another process; fewer --jobs may do");
  }
  if (child > 0) return child;
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(kLeftHalfway);
  for (auto& group : running_groups) group = 0;  // they are the parent's
  std::atexit(leave_halfway);  // whoever calls exit in `body` has not run it to its end
  int status = 0;
  try {
    body();
  } catch (...) {
    status = kLeftHalfway;
  }
  stop_children();
  _exit(status);
}

Descendants::Descendants() {
  prctl(PR_SET_CHILD_SUBREAPER, 1);
}

Descendants::~Descendants() {
  const std::string path = "/proc/self/task/" + std::to_string(getpid()) + "/children";
  for (;;) {
    std::ifstream children(path);
    pid_t child = 0;
    if (!(children >> child)) return;
    kill_and_wait(child);
  }
}

bool wait_for(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

void kill_and_wait(pid_t child) {
  kill(child, SIGKILL);
  wait_for(child);
}

void stop_children() {
  for (auto& group : running_groups) {
    const pid_t leader = group.exchange(0);
    if (leader <= 0) continue;
    kill(-leader, SIGKILL);
    end_leader(leader);
  }
}

void stop_children_on_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    if (sigismember(&ending_signals(), signal) == 1) std::signal(signal, die_with_children);
  }
}

bool Child::running() const {
  return process_ > 0 && owner_ == getpid();
}

void Child::start(const std::function<void(int in, int out)>& body) {
  stop();
  std::signal(SIGPIPE, SIG_IGN);  // what is written to one that has died must not end us
  Pipe inwards;
  Pipe outwards;
  Pipe errors;
  process_ = spawn([&] {
    setpgid(0, 0);
    reset_signals();
    dup2(errors.ends[1], STDERR_FILENO);
    body(inwards.ends[0], outwards.ends[1]);
  });
  setpgid(process_, process_);  // in both, since either may come first
  replace_group(0, process_);
  owner_ = getpid();
  to_ = unblocked(inwards.release(1));
  from_ = unblocked(outwards.release(0));
  errors_ = unblocked(errors.release(0));
}

std::string Child::stop() {
  std::string words;
  if (running()) {
    const std::optional<int> status = status_if_ended();
    if (status) words = obituary(*status);
    kill(-process_, SIGKILL);
    if (!status) end_leader(process_);
    replace_group(process_, 0);
  }
  abandon();
  return words;
}

bool Child::has_ended() const {
  siginfo_t ended{};
  return waitid(P_PID, static_cast<id_t>(process_), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 &&
         ended.si_pid == process_;
}

std::optional<int> Child::status_if_ended() const {
  constexpr double seconds_to_end = 0.1;  // one whose pipe is closed may be about to
  constexpr double seconds_to_write_core = 2;
  const Clock::time_point began = Clock::now();
  for (;;) {
    int status = 0;
    if (waitpid(process_, &status, WNOHANG) == process_) return status;
    pollfd watched{from_, 0, 0};
    poll(&watched, 1, 0);
    if ((watched.revents & POLLHUP) == 0) return std::nullopt;
    const double seconds = seconds_since(began);
    if (seconds > seconds_to_write_core) return std::nullopt;
    if (seconds > seconds_to_end && !is_writing_core(process_)) return std::nullopt;
    usleep(1000);
  }
}

void Child::abandon() {
  for (int* const end : {&to_, &from_, &errors_}) {
    if (*end >= 0) close(std::exchange(*end, -1));
  }
  process_ = 0;
}

bool wait_readable(int descriptor, double seconds) {
  pollfd watched{descriptor, POLLIN, 0};
  return poll(&watched, 1, static_cast<int>(seconds * 1000)) > 0;
}

namespace {

/// Set while something runs that must not call exit.
std::function<int()> end_with;

void end_at_once() {
  if (end_with) _exit(end_with());
}

}  // namespace

int guarding_exit(const std::function<int()>& run, const std::function<int()>& on_exit) {
  struct Guard {
    ~Guard() { end_with = nullptr; }
  } guard;
  std::atexit(end_at_once);
  end_with = on_exit;
  return run();
}

}  // namespace manifuzz
