#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "afresh/cells.hpp"
#include "geometry/manifold.hpp"
#include "scene/executor.hpp"
#include "scene/rows.hpp"

namespace manifuzz::scene {

/// A step that is divided has so many tasks, whatever runs them.
inline constexpr std::size_t kTasks = 8;

/// What a task works with, and leaves nothing in.
struct Scratch {
  std::vector<Cells::Run> runs;            ///< where some boxes' partners may lie
  std::vector<std::uint32_t> found;        ///< by one of the boxes, and room
  std::vector<std::uint32_t> partners;     ///< of a body, which may be new
  Queue touching;                          ///< pairs that touched
  Queue apart;                             ///< pairs that did not, and are not proven apart
  Queue leaving;                           ///< pairs of which a body left its box
  std::vector<Manifold<float>> manifolds;  ///< of those apart, as the kernel gave them
  std::vector<std::uint32_t> undrawn;      ///< bodies whose tight boxes are to be drawn

  /// The memory it takes.
  std::size_t bytes() const {
    return bytes_of(runs) + bytes_of(found) + bytes_of(partners) + touching.bytes() +
           apart.bytes() + leaving.bytes() + bytes_of(manifolds) + bytes_of(undrawn);
  }
};

/// Scratches that tasks borrow, each for itself, and give back. So few are in use as tasks run at
/// once, and each stays in the caches of whoever runs one task after another.
class Lending {
 public:
  /// As many as there are tasks, kTasks at most.
  explicit Lending(std::span<Scratch> all) : all_(all) {}

  /// A scratch that nobody else has for as long as this lives.
  class Loan {
   public:
    /// The first that is free; there must be one.
    explicit Loan(Lending& lending) : lending_(lending), place_(lending.borrow()) {}
    ~Loan() { lending_.is_lent_[place_].store(false, std::memory_order_release); }
    Loan(const Loan&) = delete;
    Loan& operator=(const Loan&) = delete;

    /// What is lent.
    Scratch& operator*() const { return lending_.all_[place_]; }

   private:
    Lending& lending_;
    std::size_t place_;
  };

 private:
  /// The first that is free: there is one for each task.
  std::size_t borrow() {
    std::size_t place = 0;
    while (is_lent_[place].exchange(true, std::memory_order_acquire)) {
      place = (place + 1) % all_.size();
    }
    return place;
  }

  std::span<Scratch> all_;
  std::array<std::atomic<bool>, kTasks> is_lent_{};
};

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
  /// From now on nobody but the caller runs tasks.
  void forget_executor() { executor_ = nullptr; }
  /// Whether there is one.
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
  /// Among as many tasks as so many things are divided into.
  template <class Act>
  void divide(std::size_t things, const Act& act) const {
    divide(things, tasks_for(things), act);
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
