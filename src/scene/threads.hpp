#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

namespace manifuzz::scene {

/// What threads do while they wait for long.
enum class Idle : std::uint8_t {
  sleep,  ///< to wake them takes time
  spin    ///< they look for the next call all the time, unless others need their cores
};

/// An executor on threads of its own: give `std::ref` of one to `Scene::step`. One call at a time.
/// Tasks must not throw.
class Threads {
 public:
  /// So many threads run tasks, the one that calls among them. Throws std::system_error.
  explicit Threads(std::size_t count, Idle idle = Idle::sleep)
      : idle_(idle), shares_(std::max<std::size_t>(count, 1)) {
    try {
      for (std::size_t i = 1; i < count; ++i) threads_.emplace_back([this, i] { serve(i); });
    } catch (...) {  // the system has no more of them
      end();
      throw;
    }
  }
  ~Threads() { end(); }
  Threads(const Threads&) = delete;
  Threads& operator=(const Threads&) = delete;

  /// Runs `task(0)` to `task(count - 1)`, and returns when all have ended. It waits for no thread
  /// that has not begun one. Each begins with a share of its own, which is the same in calls of as
  /// many tasks: what a task has read is in that thread's cache.
  void operator()(std::size_t count, const std::function<void(std::size_t)>& task) {
    task_ = &task;
    running_ = count;
    const std::size_t shares = shares_.size();
    for (std::size_t i = 0; i < shares; ++i) {
      shares_[i].end = (i + 1) * count / shares;
      shares_[i].left = shares_[i].end - i * count / shares;
    }
    wake();
    run_tasks(0);
    while (const std::size_t running = running_) await(running_, running);
  }

 private:
  void end() {
    is_over_ = true;
    wake();
    for (std::thread& thread : threads_) thread.join();
  }
  void wake() {
    ++calls_;
    calls_.notify_all();
  }
  /// Takes tasks while there are any, of its own share first: whoever takes one knows that its call
  /// is not over.
  void run_tasks(std::size_t own) {
    for (std::size_t i = 0; i < shares_.size(); ++i) {
      OwnTasks& share = shares_[(own + i) % shares_.size()];
      std::size_t left = share.left;
      while (left > 0) {
        if (!share.left.compare_exchange_weak(left, left - 1)) continue;
        (*task_)(share.end - left);
        if (--running_ == 0) running_.notify_one();
        left = share.left;
      }
    }
  }
  void serve(std::size_t own) {
    std::uint32_t seen = 0;
    while (!is_over_) {
      run_tasks(own);
      await(calls_, seen);
      seen = calls_;
    }
  }
  /// Waits until it has another value; what comes soon is not slept for, which takes longer than a
  /// task.
  template <class T>
  void await(const std::atomic<T>& value, T old) const {
    for (int i = 0; i < kLooks && value == old; ++i) {
    }
    if (idle_ == Idle::spin) {
      while (value == old) std::this_thread::yield();
      return;
    }
    for (int i = 0; i < kYields && value == old; ++i) std::this_thread::yield();
    value.wait(old);
  }

  static constexpr int kLooks = 2000;  // about a microsecond, which a yield alone may take
  static constexpr int kYields = 500;  // some tenths of a millisecond

  /// Tasks one after another, in a cache line.
  struct alignas(64) OwnTasks {
    std::atomic<std::size_t> left = 0;  ///< that nobody has taken: the last ones
    std::size_t end = 0;                ///< behind the last one
  };

  Idle idle_;
  std::vector<OwnTasks> shares_;  // one a thread, that of the caller first
  std::vector<std::thread> threads_;
  std::atomic<std::uint32_t> calls_ = 0;
  std::atomic<bool> is_over_ = false;
  std::atomic<std::size_t> running_ = 0;  // tasks that have not ended
  const std::function<void(std::size_t)>* task_ = nullptr;
};

}  // namespace manifuzz::scene
