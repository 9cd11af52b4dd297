#include "scene/division.hpp"

#include <atomic>
#include <new>

namespace manifuzz::scene {

/// An executor's tasks must not throw: that memory ran out in one is told when all have ended.
void Division::run_by_executor(std::size_t tasks,
                               const std::function<void(std::size_t)>& task) const {
  std::atomic<bool> is_out_of_memory = false;
  (*executor_)(tasks, [&](std::size_t i) {
    try {
      task(i);
    } catch (const std::bad_alloc&) {
      is_out_of_memory = true;
    }
  });
  if (is_out_of_memory) throw std::bad_alloc();
}

std::size_t Division::bytes() const {
  std::size_t bytes = 0;
  for (const Scratch& scratch : scratches_) bytes += scratch.bytes();
  return bytes;
}

}  // namespace manifuzz::scene
