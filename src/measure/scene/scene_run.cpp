#include "measure/scene/scene_run.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <memory>

#include "measure/scene/scene_player.hpp"
#include "measure/spread.hpp"

namespace manifuzz {
namespace {

template <class Work>
double ns_of(const Work& work) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  work();
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
}

/// The scene and both baselines, which go through a trajectory together.
class Race {
 public:
  Race(const Trajectory& trajectory, const scene::Settings& settings)
      : ours_(trajectory, settings) {
    const std::vector<Body> bodies = trajectory.bodies();
    all_ = std::make_unique<Box2dPairs>(bodies);
    moved_ = std::make_unique<Box2dPairs>(bodies);
    all_->step({}, false);
    moved_->step({}, true);
  }

  /// The times of the scene, of all pairs and of the moved ones; who begins changes by step.
  std::array<double, 3> step(std::span<const BodyMove> moves, std::size_t number) {
    ours_.prepare(moves);
    std::array<double, 3> ns{};
    for (std::size_t i = 0; i < ns.size(); ++i) {
      const std::size_t turn = (number + i) % ns.size();
      if (turn == 0) ns[0] = ns_of([&] { ours_.step_prepared(); });
      if (turn == 1) ns[1] = ns_of([&] { all_->step(moves, false); });
      if (turn == 2) ns[2] = ns_of([&] { moved_->step(moves, true); });
    }
    return ns;
  }

  const scene::Scene& scene() const { return ours_.scene(); }
  const scene::StepResult& result() const { return ours_.result(); }

 private:
  ScenePlayer ours_;
  std::unique_ptr<Box2dPairs> all_;
  std::unique_ptr<Box2dPairs> moved_;
};

void add_to(scene::StepCounts& sum, const scene::StepCounts& counts) {
  sum.pairs.at_rest += counts.pairs.at_rest;
  sum.pairs.separated += counts.pairs.separated;
  sum.pairs.recycled += counts.pairs.recycled;
  sum.pairs.collided += counts.pairs.collided;
  sum.pairs.candidates += counts.pairs.candidates;
  sum.moved += counts.moved;
  sum.left_boxes += counts.left_boxes;
  sum.proofs += counts.proofs;
}

}  // namespace

SceneRun run_scene(std::string_view name, const Trajectory& trajectory,
                   const scene::Settings& settings) {
  SceneRun run;
  run.scene = name;
  run.bodies = trajectory.start.size();
  run.steps = trajectory.steps.size();
  run.recycled_motion = settings.recycled_motion;
  // Apart from what is timed: it would empty the caches.
  if (settings.recycled_motion == 0) run.afresh = check_afresh(trajectory, settings);
  Race race(trajectory, settings);
  std::vector<double> ns;
  std::vector<double> over_all;
  std::vector<double> over_moved;
  for (std::size_t step = 0; step < run.steps; ++step) {
    const auto& moves = trajectory.steps[step];
    const auto [ours, all, moved] = race.step(moves, step);
    ns.push_back(ours);
    over_all.push_back(all / ours);
    over_moved.push_back(moved / ours);
    add_to(run.counts, race.result().counts);
  }
  run.ns_per_step = median(ns);
  run.speedup_over_all = median(over_all);
  run.speedup_over_moved = median(over_moved);
  run.contacts = race.result().contacts.size();
  run.pairs = race.scene().pair_count();
  run.memory = race.scene().memory();
  return run;
}

Frame last_frame(const Trajectory& trajectory, const scene::Settings& settings) {
  Frame frame{trajectory.bodies(), {}};
  ScenePlayer player(trajectory, settings);
  for (const auto& moves : trajectory.steps) {
    move_bodies(moves, frame.bodies);
    player.step(moves);
  }
  const auto contacts = player.result().contacts;
  frame.contacts.assign(contacts.begin(), contacts.end());
  return frame;
}

std::optional<double> fitted_exponent(const std::vector<std::pair<double, double>>& points) {
  double mean_x = 0;
  double mean_y = 0;
  const auto count = static_cast<double>(points.size());
  for (const auto& [x, y] : points) {
    mean_x += std::log(x) / count;
    mean_y += std::log(y) / count;
  }
  double above = 0;
  double below = 0;
  for (const auto& [x, y] : points) {
    const double off = std::log(x) - mean_x;
    above += off * (std::log(y) - mean_y);
    below += off * off;
  }
  if (!(below > 0)) return std::nullopt;
  return above / below;
}

}  // namespace manifuzz
