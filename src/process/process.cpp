#include "process/process.hpp"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

#include "process/child.hpp"

namespace manifuzz {
namespace {

constexpr int kLeftHalfway = 3;

/// How often somebody asked this process to stop, whichever Interruption took it.
int requests_taken = 0;

void leave_halfway() {
  _exit(kLeftHalfway);
}

}  // namespace

SharedMemory::SharedMemory(std::size_t bytes)
    : data_(mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)),
      bytes_(bytes) {
  if (data_ == MAP_FAILED) throw std::bad_alloc();
}

SharedMemory::~SharedMemory() {
  munmap(data_, bytes_);
}

pid_t spawn(const std::function<void()>& body) {
  std::fflush(nullptr);
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child < 0)
    throw std::system_error(errno, std::generic_category(),
                            "cannot start another process; fewer --jobs may do");
  if (child > 0) return child;
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(kLeftHalfway);
  disown_children();
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

struct Interruption::Masks {
  sigset_t held;
  sigset_t before;
  sigset_t stop;
};

Interruption::Interruption(Deadline deadline)
    : masks_(new Masks), deadline_(deadline), before_(requests_taken) {
  sigemptyset(&masks_->stop);
  sigaddset(&masks_->stop, SIGINT);
  sigaddset(&masks_->stop, SIGTERM);
  masks_->held = masks_->stop;
  sigaddset(&masks_->held, SIGCHLD);
  sigprocmask(SIG_BLOCK, &masks_->held, &masks_->before);
}

Interruption::~Interruption() {
  requested();  // takes what is pending, lest it strike when the mask is lifted
  sigprocmask(SIG_SETMASK, &masks_->before, nullptr);
  delete masks_;
}

void Interruption::wait(double seconds) {
  const auto whole = static_cast<time_t>(seconds);
  const timespec timeout{whole, static_cast<long>((seconds - static_cast<double>(whole)) * 1e9)};
  const int signal = sigtimedwait(&masks_->held, nullptr, &timeout);
  if (signal == SIGINT || signal == SIGTERM) ++requests_taken;
}

bool Interruption::requested() {
  return requests() > forgiven_ || has_passed(deadline_);
}

int Interruption::requests() {
  const timespec at_once{0, 0};
  while (sigtimedwait(&masks_->stop, nullptr, &at_once) > 0) ++requests_taken;
  return requests_taken - before_;
}

}  // namespace manifuzz
