#include "process/process.hpp"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

#include "process/child.hpp"

namespace manifuzz {
namespace {

constexpr int kLeftHalfway = 3;

void leave_halfway() {
  _exit(kLeftHalfway);
}

}  // namespace

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

}  // namespace manifuzz
