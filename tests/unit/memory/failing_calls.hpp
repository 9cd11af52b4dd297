#pragma once

#include <cstddef>
#include <functional>

#include "scene/scene.hpp"

namespace manifuzz::test {

/// What a call that had no memory leaves of a scene's pairs.
enum class After { unchanged, forgotten };

/// A call on a scene.
struct Command {
  const char* name;
  After after;
  std::function<void(scene::Scene&)> run;
};

/// Lets each allocation of a call fail once, in a copy of the scene each, and checks what the
/// scene's header states; how many allocations there were.
std::size_t check_every_failure(const scene::Scene& before, const Command& command);

}  // namespace manifuzz::test
