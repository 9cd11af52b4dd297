#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

namespace manifuzz::scene {

/// An executor on threads of its own, which sleep between its calls: give `std::ref` of one to
/// `Scene::step`. One call at a time. Tasks must not throw.
class Threads {
 public:
  /// So many threads run tasks, the one that calls among them.
  explicit Threads(std::size_t count) {
    for (std::size_t i = 1; i < count; ++i) threads_.emplace_back([this] { serve(); });
  }
  ~Threads() {
    is_over_ = true;
    begin_round();
    for (std::thread& thread : threads_) thread.join();
  }
  Threads(const Threads&) = delete;
  Threads& operator=(const Threads&) = delete;

  /// Runs `task(0)` to `task(count - 1)`, and returns when all have ended.
  void operator()(std::size_t count, const std::function<void(std::size_t)>& task) {
    task_ = &task;
    count_ = count;
    next_ = 0;
    working_ = threads_.size();
    begin_round();
    run_tasks();
    while (const std::size_t left = working_) working_.wait(left);
  }

 private:
  void begin_round() {
    ++round_;
    round_.notify_all();
  }
  void run_tasks() {
    for (std::size_t i = next_++; i < count_; i = next_++) (*task_)(i);
  }
  /// Every thread takes part in every round, so that none is late for one that is over.
  void serve() {
    for (std::uint32_t seen = 0;; ++seen) {
      round_.wait(seen);
      if (is_over_) return;
      run_tasks();
      if (--working_ == 0) working_.notify_one();
    }
  }

  std::vector<std::thread> threads_;
  std::atomic<std::uint32_t> round_ = 0;
  std::atomic<bool> is_over_ = false;
  std::atomic<std::size_t> next_ = 0;     // the task to be taken
  std::atomic<std::size_t> working_ = 0;  // threads that have not ended their round
  std::size_t count_ = 0;
  const std::function<void(std::size_t)>* task_ = nullptr;
};

}  // namespace manifuzz::scene
