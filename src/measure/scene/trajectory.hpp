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

  /// As they start.
  std::vector<Body> bodies() const {
    std::vector<Body> all;
    for (const auto& [shape, pose] : start) all.push_back({shapes[shape], pose});
    return all;
  }
};

/// Puts bodies where they are now.
inline void move_bodies(std::span<const BodyMove> moves, std::vector<Body>& bodies) {
  for (const BodyMove& move : moves) bodies[move.body].pose = move.pose;
}

/// A named family of scenes, of any number of bodies.
struct SceneSpec {
  std::string_view name;
  std::string_view sentence;
  Trajectory (*make)(std::size_t bodies, int steps);
};

/// All scenes, in the order of reports.
std::span<const SceneSpec> scene_specs();

}  // namespace manifuzz
