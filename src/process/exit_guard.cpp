#include "process/exit_guard.hpp"

#include <cstdlib>
#include <unistd.h>

namespace manifuzz {
namespace {

/// Set while something runs that must not call exit.
std::function<int()> end_with;

void end_at_once() {
  if (end_with) _exit(end_with());
}

}  // namespace

int guarding_exit(const std::function<int()>& run, const std::function<int()>& on_exit) {
  std::atexit(end_at_once);
  end_with = on_exit;
  try {
    const int status = run();
    end_with = nullptr;
    return status;
  } catch (...) {
    end_with = nullptr;
    throw;
  }
}

}  // namespace manifuzz
