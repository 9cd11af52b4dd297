#pragma once

#include <functional>
#include <sys/types.h>

namespace manifuzz {

/// Runs `body` in a child process, which dies with its parent. Once `body` has run, it stops its
/// own `Child`ren and exits with status 0, or 3 where `body` throws or calls exit. Throws
/// std::system_error where no process is to be had.
pid_t spawn(const std::function<void()>& body);

/// Waits for a child to end; whether it ended well.
bool wait_for(pid_t child);

/// Ends a child at once and waits for it.
void kill_and_wait(pid_t child);

/// Whoever a child of this process leaves behind is ended with this: a program's own children too.
class Descendants {
 public:
  Descendants();
  ~Descendants();
  Descendants(const Descendants&) = delete;
  Descendants& operator=(const Descendants&) = delete;
};

}  // namespace manifuzz
