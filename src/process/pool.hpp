#pragma once

#include <atomic>
#include <cstdint>
#include <functional>

#include "process/interruption.hpp"

namespace manifuzz {

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
