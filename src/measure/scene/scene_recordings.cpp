#include "measure/scene/scene_recordings.hpp"

#include <algorithm>

#include "generating/placing.hpp"
#include "geometry/same_bits.hpp"
#include "measure/scene/scene_scripts.hpp"
#include "oracle/box2d/world.hpp"

namespace manifuzz {
namespace {

/// What is simulated at once; more would take long to come to rest.
constexpr std::size_t kRecordedMax = 500;

/// A world whose bodies are polygons of a list.
struct Stage {
  std::vector<ConvexPolygon<float>> shapes;
  std::vector<WorldBody> bodies;
  std::vector<std::uint32_t> shape_of;
  double width = 0;  ///< from one recording to the next

  void add(std::uint32_t shape, double x, double y, bool is_fixed = false) {
    const Pose<float> pose{Vector2<double>(x, y).cast<float>(), {1, 0}};
    bodies.push_back({{shapes[shape], pose}, is_fixed});
    shape_of.push_back(shape);
  }

  /// A floor whose top is y = 0, as wide as the stage, and walls if they have a height.
  void enclose(double wall_height) {
    const auto add_fixed = [&](double half_width, double half_height, double x, double y) {
      shapes.push_back(*rounded(box(half_width, half_height), 0.01F));
      add(static_cast<std::uint32_t>(shapes.size() - 1), x, y, true);
    };
    add_fixed(width / 2, 0.5, width / 2, -0.5);
    if (wall_height == 0) return;
    add_fixed(0.5, wall_height / 2, 0.5, wall_height / 2);
    add_fixed(0.5, wall_height / 2, width - 0.5, wall_height / 2);
  }
};

/// The stage's recording after `warm_up` steps, side by side until there are enough bodies.
Trajectory recorded(const Stage& stage, std::size_t bodies, int warm_up, int steps) {
  const auto poses = box2d_trajectory(stage.bodies, warm_up + steps);
  Trajectory trajectory{stage.shapes, {}, {}};
  const std::size_t in_stage = stage.bodies.size();
  const auto pose_at = [&](std::size_t i, int step) {
    Pose<float> pose = poses[static_cast<std::size_t>(step)][i % in_stage];
    pose.position.x() += static_cast<float>(stage.width) * static_cast<float>(i / in_stage);
    return pose;
  };
  for (std::size_t i = 0; i < bodies; ++i) {
    trajectory.start.push_back({stage.shape_of[i % in_stage], pose_at(i, warm_up - 1)});
  }
  for (int step = warm_up; step < warm_up + steps; ++step) {
    std::vector<BodyMove>& moves = trajectory.steps.emplace_back();
    for (std::uint32_t i = 0; i < bodies; ++i) {
      const Pose<float> pose = pose_at(i, step);
      if (!same_bits(pose, pose_at(i, step - 1))) moves.push_back({i, pose});
    }
  }
  return trajectory;
}

Stage pile_stage(std::size_t bodies) {
  Stage stage;
  stage.shapes = mixed_shapes();
  const auto mixed = static_cast<std::uint32_t>(stage.shapes.size());
  const std::size_t columns = 20;
  const std::size_t dynamic = std::min(bodies, kRecordedMax) - 3;
  stage.width = 1.1 * static_cast<double>(columns) + 1.5;
  stage.enclose(2.0 + 1.2 * static_cast<double>(dynamic / columns));
  Random random(1, "pile", 0);
  for (std::uint32_t i = 0; i < dynamic; ++i) {
    const double x = 1.4 + 1.1 * static_cast<double>(i % columns) + random.uniform(-0.1, 0.1);
    stage.add(i % mixed, x, 0.6 + 1.1 * static_cast<double>(i / columns));
  }
  return stage;
}

}  // namespace

Trajectory make_pile(std::size_t bodies, int steps) {
  return recorded(pile_stage(bodies), bodies, 90, steps);
}

Trajectory make_resting_pile(std::size_t bodies, int steps) {
  Trajectory trajectory = recorded(pile_stage(bodies), bodies, 600, 1);
  trajectory.steps.clear();
  Random random(1, "resting pile", 0);
  std::vector<bool> is_nudged(bodies);
  for (std::size_t step = 0; step < static_cast<std::size_t>(steps); ++step) {
    std::vector<BodyMove>& moves = trajectory.steps.emplace_back();
    for (std::uint32_t i = static_cast<std::uint32_t>(step % 10); i < bodies; i += 10) {
      Pose<float> pose = trajectory.start[i].pose;
      is_nudged[i] = !is_nudged[i];
      if (is_nudged[i]) pose.position += (0.005 * random_direction(random)).cast<float>();
      moves.push_back({i, pose});
    }
  }
  return trajectory;
}

Trajectory make_pyramid(std::size_t bodies, int steps) {
  constexpr std::uint32_t kBase = 28;
  Stage stage;
  stage.shapes = {*rounded(box(0.5, 0.5), 0.01F)};
  stage.width = kBase * 1.1 + 4;
  stage.enclose(0);
  for (std::uint32_t row = 0; row < kBase; ++row) {
    for (std::uint32_t i = row; i < kBase; ++i) {
      if (stage.bodies.size() >= bodies) break;
      stage.add(0, 2.5 + 1.1 * (i - row / 2.0), 0.6 + 1.05 * row);
    }
  }
  return recorded(stage, bodies, 20, steps);
}

Trajectory make_rain(std::size_t bodies, int steps) {
  Stage stage;
  stage.shapes = mixed_shapes();
  const auto mixed = static_cast<std::uint32_t>(stage.shapes.size());
  const auto dynamic = static_cast<std::uint32_t>(std::min(bodies, kRecordedMax) - 1);
  stage.width = 120;
  stage.enclose(0);
  Random random(1, "rain", 0);
  for (std::uint32_t i = 0; i < dynamic; ++i) {
    const double x = random.uniform(2, stage.width - 2);
    stage.add(i % mixed, x, 1.0 + 0.3 * i);
  }
  return recorded(stage, bodies, 120, steps);
}

}  // namespace manifuzz
