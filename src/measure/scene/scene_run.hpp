#pragma once

#include <optional>
#include <string>
#include <vector>

#include "measure/scene/scene_afresh.hpp"
#include "scene/scene.hpp"

namespace manifuzz {

/// A trajectory gone through by a scene and by both baselines, step by step in turn: Box2D's broad
/// phase and its `b2CollidePolygons` on every pair (all), or on those of which a body moved
/// (moved).
struct SceneRun {
  std::string scene;
  std::size_t bodies = 0;
  std::size_t steps = 0;
  float recycled_motion = 0;      ///< 0 is strict
  double ns_per_step = 0;         ///< the median of the steps
  double speedup_over_all = 0;    ///< the median of the steps' ratios
  double speedup_over_moved = 0;  ///< likewise
  scene::StepCounts counts;       ///< sums over the steps
  std::size_t contacts = 0;       ///< after the last step
  std::size_t pairs = 0;          ///< candidates after the last step
  scene::Memory memory;           ///< after the last step
  AfreshCheck afresh;             ///< of no step where contacts are recycled
};

/// The first step, in which everything is new, is not counted.
SceneRun run_scene(std::string_view name, const Trajectory& trajectory,
                   const scene::Settings& settings);

/// Bodies in the world, and how they touch; their handles have the bodies' indices.
struct Frame {
  std::vector<Body> bodies;
  std::vector<scene::Contact> contacts;
};

/// As a trajectory leaves them.
Frame last_frame(const Trajectory& trajectory, const scene::Settings& settings);

/// The exponent k of y ~ x^k that fits points best, in logarithms; none for fewer than two x.
std::optional<double> fitted_exponent(const std::vector<std::pair<double, double>>& points);

}  // namespace manifuzz
