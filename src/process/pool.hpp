#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "process/interruption.hpp"

namespace manifuzz {

/// Zeroed memory that children share with their parent.
using SharedMemory = std::unique_ptr<void, std::function<void(void*)>>;

/// So many bytes of it. Throws std::bad_alloc.
SharedMemory shared_memory(std::size_t bytes);

/// A value in shared memory, or several. T must hold no pointers and need no destructor.
template <class T>
class Shared {
 public:
  explicit Shared(std::size_t count = 1)
      : memory_(shared_memory(count * sizeof(T))), values_(static_cast<T*>(memory_.get()), count) {
    std::uninitialized_value_construct(values_.begin(), values_.end());
  }
  T& operator*() const { return values_[0]; }
  T* operator->() const { return values_.data(); }
  T& operator[](std::size_t i) const { return values_[i]; }
  std::span<T> all() const { return values_; }

 private:
  SharedMemory memory_;
  std::span<T> values_;
};

/// Text for shared memory; what is too long is cut off.
template <std::size_t Size>
class SharedText {
 public:
  void set(std::string_view text) { characters_[text.copy(characters_.data(), Size - 1)] = 0; }
  void set(const char* text) { set(std::string_view(text == nullptr ? "" : text)); }
  const char* c_str() const { return characters_.data(); }
  std::string str() const { return c_str(); }

 private:
  std::array<char, Size> characters_{};
};

/// The numbers that the jobs of a pool take their work from; lies in shared memory.
struct SharedQueue {
  struct Block {
    std::uint64_t begin = 0;
    std::uint64_t end = 0;  ///< one behind the last
  };

  std::atomic<std::uint64_t> next{0};
  std::uint64_t end = 0;
  std::atomic<bool> is_closed{false};  ///< nothing more is taken, and what is at work ends soon

  bool is_open() const { return !is_closed.load(std::memory_order_relaxed); }
  /// The next numbers, so many or what is left of them; empty where none are.
  Block take(std::uint64_t length);
};

/// How a child ended: it had run `body` to its end, it died, it made no progress for too long, or
/// it was stopped.
enum class Ending { done, crashed, timed_out, stopped };

/// Child processes that work side by side and are watched from here.
struct Pool {
  int jobs = 1;
  std::function<void(int job)> body;  ///< what a job does, in its child
  /// A number that moves while the job works: one whose number stands still for `seconds_max` is
  /// ended.
  std::function<std::uint64_t(int job)> progress;
  double seconds_max = 0;
  /// Runs here once a job's child has crashed or timed out: whether another goes on in its place.
  std::function<bool(int job, Ending ending)> on_lost;
  std::atomic<bool>* hurry = nullptr;  ///< set, in shared memory, once jobs are to end fast
  std::function<void(double seconds)> on_tick{};  ///< runs a few times a second, for people
};

struct PoolResult {
  bool is_stopped = false;  ///< its children were ended before they were done
  double seconds = 0;
};

/// Runs every job until it is done, is not replaced, or the interruption is stopped. Throws
/// std::system_error where no process is to be had. No child outlives the call.
PoolResult run_pool(const Pool& pool, Interruption& interruption);

/// A pool of one child that is not replaced. Without `progress`, `seconds_max` is all it has.
Ending run_in_child(const std::function<void()>& body, double seconds_max,
                    Interruption& interruption, const std::function<std::uint64_t()>& progress = {},
                    std::atomic<bool>* hurry = nullptr);

}  // namespace manifuzz
