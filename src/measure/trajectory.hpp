#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "kernel/packed.hpp"
#include "oracle/box2d/pairs.hpp"

namespace manifuzz {

/// A scene's bodies and what moves in each of its steps.
struct Trajectory {
  std::vector<ConvexPolygon<float>> shapes;
  std::vector<kernel::Placement<float>> start;
  std::vector<std::vector<BodyMove>> steps;

  Body body(std::size_t i) const { return {shapes[start[i].shape], start[i].pose}; }
};

/// A named family of scenes, of any number of bodies.
struct SceneSpec {
  std::string_view name;
  std::string_view sentence;
  Trajectory (*make)(std::size_t bodies, int steps);
};

/// All scenes, in the order of reports.
std::span<const SceneSpec> scene_specs();

/// None where there is none of this name.
const SceneSpec* find_scene(std::string_view name);

}  // namespace manifuzz
