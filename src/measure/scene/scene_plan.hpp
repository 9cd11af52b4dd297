#pragma once

#include <filesystem>
#include <functional>
#include <string_view>
#include <vector>

#include "measure/scene/scene_recycling.hpp"
#include "measure/scene/scene_run.hpp"

namespace manifuzz {

/// Each of these scenes at each number of bodies.
struct ScenePlan {
  std::vector<const SceneSpec*> scenes;
  std::vector<std::size_t> sizes;  ///< numbers of bodies, rising
  int steps = 30;
  scene::Settings settings;
  bool has_curves = false;  ///< recycling at every motion as well, at the least number of bodies
};

struct SceneResult {
  std::vector<SceneRun> runs;  ///< those of one scene follow each other
  std::vector<RecyclingCurve> curves;
};

/// `on_scene` is told what comes next: "timing" or "recycling", of which scene, how many bodies.
SceneResult run_scenes(const ScenePlan& plan,
                       const std::function<void(std::string_view doing, std::string_view scene,
                                                std::size_t bodies)>& on_scene);

/// Writes the pairs that were not as they are afresh to a corpus, whose cases the tests put into
/// scenes. Throws UserError.
void save_mismatches(const std::filesystem::path& corpus, const std::vector<SceneRun>& runs);

}  // namespace manifuzz
