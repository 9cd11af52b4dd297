#pragma once

#include <functional>
#include <optional>
#include <string>
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
  Descendants& operator=(Descendants&&) = delete;  // neither moved nor copied
};

/// A child process with a pipe to it, one from it and one from its standard error, in a process
/// group of its own. It belongs to the process that started it: in a fork of that, it counts as not
/// started.
class Child {
 public:
  Child() = default;
  ~Child() { stop(); }
  Child& operator=(Child&&) = delete;  // neither moved nor copied

  bool running() const;
  /// Whether it has ended by itself; what it started may live on.
  bool has_ended() const;
  /// Stops what runs; then `body` runs in the child, `in` and `out` being its ends of the pipes.
  /// Throws std::system_error where no process is to be had.
  void start(const std::function<void(int in, int out)>& body);
  /// Ends it at once, with all that it started and left in its group. Says in words how it had
  /// ended, if it had by itself.
  std::string stop();

  pid_t process() const { return process_; }
  int to() const { return to_; }          ///< where to write to it; writes do not block
  int from() const { return from_; }      ///< where to read from it; reads do not block
  int errors() const { return errors_; }  ///< the same of its standard error

 private:
  std::optional<int> status_if_ended() const;
  void abandon();

  pid_t process_ = 0;
  pid_t owner_ = 0;
  int to_ = -1;
  int from_ = -1;
  int errors_ = -1;
};

/// Stops every child of this process: destructors do not run in one that exits at once.
void stop_children();

/// From here on SIGINT, SIGTERM and SIGHUP stop the children before they end this process, with the
/// status that says so.
void stop_children_on_signals();

/// Waits until something is to be read, at most so long; whether it is.
bool wait_readable(int descriptor, double seconds);

/// Runs it. Where anything calls exit meanwhile, the process ends at once with the status that
/// `on_exit` gives.
int guarding_exit(const std::function<int()>& run, const std::function<int()>& on_exit);

}  // namespace manifuzz
