#pragma once

#include "measure/scene/trajectory.hpp"
#include "scene/scene.hpp"

namespace manifuzz {

/// A scene with a trajectory's bodies, which have the same indices there.
class ScenePlayer {
 public:
  ScenePlayer(const Trajectory& trajectory, const scene::Settings& settings) : scene_(settings) {
    for (const auto& shape : trajectory.shapes) scene_.add_shape(shape);
    for (const auto& [shape, pose] : trajectory.start) {
      handles_.push_back(std::get<scene::BodyHandle>(scene_.add(shape, pose)));
    }
    step({});
  }

  /// Valid until the next one, as is what the others give.
  const scene::StepResult& step(std::span<const BodyMove> moves) {
    prepare(moves);
    return step_prepared();
  }

  void prepare(std::span<const BodyMove> moves) {
    moves_.clear();
    for (const BodyMove& move : moves) moves_.push_back({handles_[move.body], move.pose});
  }
  const scene::StepResult& step_prepared() {
    const auto stepped = scene_.step(moves_);
    result_ = std::get<scene::StepResult>(stepped);
    return result_;
  }

  const scene::StepResult& result() const { return result_; }
  const scene::Scene& scene() const { return scene_; }

 private:
  scene::Scene scene_;
  std::vector<scene::BodyHandle> handles_;
  std::vector<scene::Move> moves_;
  scene::StepResult result_;
};

}  // namespace manifuzz
