#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

#include "afresh/cells.hpp"
#include "geometry/manifold.hpp"
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
    explicit Loan(Lending& lending) : lending_(lending), place_(lending.borrow()) {}
    ~Loan() { lending_.is_lent_[place_].store(false, std::memory_order_release); }
    Loan(const Loan&) = delete;
    Loan& operator=(const Loan&) = delete;

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

}  // namespace manifuzz::scene
