#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

namespace manifuzz::scene {

/// An executor on threads of its own, which sleep where calls are far between: give `std::ref` of
/// one to `Scene::step`. One call at a time. Tasks must not throw.
class Threads {
 public:
  /// So many threads run tasks, the one that calls among them. Throws std::system_error.
  explicit Threads(std::size_t count) {
    try {
      for (std::size_t i = 1; i < count; ++i) threads_.emplace_back([this] { serve(); });
    } catch (...) {  // the system has no more of them
      end();
      throw;
    }
  }
  ~Threads() { end(); }
  Threads(const Threads&) = delete;
  Threads& operator=(const Threads&) = delete;

  /// Runs `task(0)` to `task(count - 1)`, and returns when all have ended. It waits for no thread
  /// that has not begun one.
  void operator()(std::size_t count, const std::function<void(std::size_t)>& task) {
    task_ = &task;
    running_ = count;
    left_ = count;
    wake();
    run_tasks();
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
  /// Takes tasks while there are any: whoever takes one knows that its call is not over.
  void run_tasks() {
    std::size_t left = left_;
    while (left > 0) {
      if (!left_.compare_exchange_weak(left, left - 1)) continue;
      (*task_)(left - 1);
      if (--running_ == 0) running_.notify_one();
      left = left_;
    }
  }
  void serve() {
    std::uint32_t seen = 0;
    while (!is_over_) {
      run_tasks();
      await(calls_, seen);
      seen = calls_;
    }
  }
  /// Until it has another value; what comes soon is not slept for, which takes longer than a task.
  template <class T>
  static void await(const std::atomic<T>& value, T old) {
    for (int i = 0; i < kYields && value == old; ++i) std::this_thread::yield();
    value.wait(old);
  }

  static constexpr int kYields = 500;  // some tenths of a millisecond

  std::vector<std::thread> threads_;
  std::atomic<std::uint32_t> calls_ = 0;
  std::atomic<bool> is_over_ = false;
  std::atomic<std::size_t> left_ = 0;     // tasks that nobody has taken
  std::atomic<std::size_t> running_ = 0;  // tasks that have not ended
  const std::function<void(std::size_t)>* task_ = nullptr;
};

}  // namespace manifuzz::scene
