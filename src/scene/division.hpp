#pragma once

#include <functional>
#include <vector>

#include "scene/executor.hpp"
#include "scene/scratch.hpp"

namespace manifuzz::scene {

/// From the first to before the last of some things.
struct Share {
  std::size_t first;  ///< of its things
  std::size_t last;   ///< behind its last one
};

/// What one of so many tasks has of so many things.
inline Share share_of(std::size_t things, std::size_t task, std::size_t tasks) {
  return {task * things / tasks, (task + 1) * things / tasks};
}

/// How a step is divided into tasks, and who runs them: an executor, or nobody but the caller.
class Division {
 public:
  /// From now on; an executor that is empty is none.
  void set_executor(const Executor& executor) { executor_ = executor ? &executor : nullptr; }
  void forget_executor() { executor_ = nullptr; }
  bool has_executor() const { return executor_ != nullptr; }

  /// Into how many tasks all rows are divided.
  std::size_t row_tasks() const { return has_executor() ? kTasks : 1; }
  /// Into how many tasks so many things are divided: more than one only with an executor.
  std::size_t tasks_for(std::size_t things) const { return things > 8 * kTasks ? row_tasks() : 1; }

  /// `task(i)` of so many. One is run here; more by the executor.
  template <class Task>
  void run(std::size_t tasks, const Task& task) const {
    if (tasks > 1) return run_by_executor(tasks, std::cref(task));
    task(std::size_t{0});
  }
  /// `act(share, task)` of each of so many tasks, among which so many things are divided.
  template <class Act>
  void divide(std::size_t things, std::size_t tasks, const Act& act) const {
    run(tasks, [&](std::size_t task) { act(share_of(things, task, tasks), task); });
  }
  /// `act(share, task, scratch)`, likewise; the scratch is a task's own while it runs.
  template <class Act>
  void divide_with_scratch(std::size_t things, std::size_t tasks, const Act& act) {
    if (scratches_.size() < tasks) scratches_.resize(tasks);
    if (tasks == 1) return act(share_of(things, 0, 1), std::size_t{0}, scratches_.front());
    Lending lending(scratches_);
    divide(things, tasks, [&](const Share& share, std::size_t task) {
      act(share, task, *Lending::Loan(lending));
    });
  }

  /// Without what tasks worked with: memory ran out.
  void forget() {
    forget_executor();
    scratches_.clear();
  }

  /// The memory it takes.
  std::size_t bytes() const;

 private:
  void run_by_executor(std::size_t tasks, const std::function<void(std::size_t)>& task) const;

  const Executor* executor_ = nullptr;
  std::vector<Scratch> scratches_;
};

}  // namespace manifuzz::scene
