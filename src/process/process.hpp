#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <new>
#include <optional>
#include <sys/types.h>

namespace manifuzz {

/// Zeroed memory that children share with their parent. Throws std::bad_alloc.
class SharedMemory {
 public:
  explicit SharedMemory(std::size_t bytes);
  ~SharedMemory();
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;

  void* data() const { return data_; }

 private:
  void* data_;
  std::size_t bytes_;
};

/// A value in shared memory. T must hold no pointers and need no destructor.
template <class T>
class Shared {
 public:
  Shared() : memory_(sizeof(T)), value_(new (memory_.data()) T) {}
  T& operator*() const { return *value_; }
  T* operator->() const { return value_; }

 private:
  SharedMemory memory_;
  T* value_;
};

/// Runs `body` in a child process, which dies with its parent. Once `body` has run, it stops its
/// own `Child`ren and exits with status 0, or 3 where `body` throws or calls
/// exit. Throws std::system_error when
/// no process is to be had.
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

/// A moment by which work must stop; none: it may take as long as it takes.
using Deadline = std::optional<std::chrono::steady_clock::time_point>;
inline bool has_passed(const Deadline& deadline) {
  return deadline && std::chrono::steady_clock::now() >= *deadline;
}

/// Holds SIGINT and SIGTERM back for as long as it lives, so that work can stop in good order. One
/// that lives around another counts its requests too.
class Interruption {
 public:
  explicit Interruption(Deadline deadline = {});
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  /// Waits until a signal or a child's end, at most so long.
  void wait(double seconds);
  /// Whether somebody asked to stop, since this lives, or the deadline has passed.
  bool requested();
  /// How often somebody asked.
  int requests();
  /// From here on only a signal more counts as a request.
  void forgive() { forgiven_ = requests(); }
  /// As if somebody had asked and been forgiven, before this one lived.
  void hurry() {
    --before_;
    forgive();
  }

 private:
  struct Masks;
  Masks* masks_;
  Deadline deadline_;
  int before_;  ///< requests to those before this one
  int forgiven_ = 0;
};

}  // namespace manifuzz
