#include "engines/engine.hpp"

#include <algorithm>
#include <cassert>

namespace manifuzz {

const SceneBaseline& scene_baseline() {
  const auto has_scenes = [](const Engine& engine) { return engine.scenes.pairs != nullptr; };
  const auto found = std::ranges::find_if(built_engines(), has_scenes);
  assert(found != built_engines().end());
  return found->scenes;
}

}  // namespace manifuzz
