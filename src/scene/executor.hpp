#pragma once

#include <cstddef>
#include <functional>

namespace manifuzz::scene {

/// Runs `task(0)` to `task(count - 1)`, on any threads and in any order, and returns when all have
/// ended. It must not throw, nor must a task. A scene that is given one divides a step into tasks
/// whose number does not depend on threads: contacts, their order and all counts are those of one
/// thread.
using Executor =
    std::function<void(std::size_t count, const std::function<void(std::size_t)>& task)>;

}  // namespace manifuzz::scene
