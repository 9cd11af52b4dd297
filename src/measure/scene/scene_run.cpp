#include "measure/scene/scene_run.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "measure/median.hpp"
#include "measure/scene/scene_player.hpp"

namespace manifuzz {
namespace {

template <class Work>
double ns_of(const Work& work) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  work();
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
}

/// The three that go through a trajectory.
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

nlohmann::ordered_json row_json(const SceneRun& run) {
  const scene::StepCounts& counts = run.counts;
  nlohmann::ordered_json json{
      {"scene", run.scene},
      {"bodies", run.bodies},
      {"moving", static_cast<double>(counts.moved) / static_cast<double>(run.steps)},
      {"mode", run.recycled_motion > 0 ? "recycle" : "strict"},
      {"recycled_motion", run.recycled_motion},
      {"steps", run.steps},
      {"ns_per_step", run.ns_per_step},
      {"speedup_over_box2d", run.speedup_over_all},
      {"speedup_over_box2d_moved", run.speedup_over_moved},
      {"mismatches", nullptr},
      {"steps_held_against_afresh", run.afresh.steps},
      {"candidates", counts.pairs.candidates},
      {"skipped",
       {{"at_rest", counts.pairs.at_rest},
        {"separated", counts.pairs.separated},
        {"recycled", counts.pairs.recycled}}},
      {"computed", counts.pairs.collided},
      {"left_boxes", counts.left_boxes},
      {"proofs", counts.proofs},
      {"contacts", run.contacts},
      {"pairs", run.pairs},
      {"bytes", run.memory.bodies + run.memory.pairs},
      {"bytes_of_bodies", run.memory.bodies},
      {"bytes_of_pairs", run.memory.pairs}};
  if (run.afresh.steps > 0) json["mismatches"] = run.afresh.mismatches;
  return json;
}

std::string rows_table(const std::vector<SceneRun>& runs) {
  std::string text = fmt::format(
      "{:<14} {:>7} {:>10} {:>7} {:>8} {:>9} {:>7} {:>7} {:>10} {:>10} {:>9} {:>7} {:>7} {:>10}\n",
      "scene", "bodies", "us a step", "x all", "x moved", "pairs", "% rest", "% apart",
      "% recycled", "% collided", "contacts", "B/body", "B/pair", "mismatches");
  for (const SceneRun& run : runs) {
    const auto per = [](std::size_t part, std::size_t all) {
      return static_cast<double>(part) / static_cast<double>(std::max<std::size_t>(1, all));
    };
    const scene::PairCounts& pairs = run.counts.pairs;
    const auto percent = [&](std::size_t part) { return 100 * per(part, pairs.candidates); };
    text += fmt::format(
        "{:<14} {:>7} {:>10.2f} {:>7.2f} {:>8.2f} {:>9} {:>7.1f} {:>7.1f} {:>10.1f} {:>10.1f} "
        "{:>9} {:>7.0f} {:>7.0f} {:>10}\n",
        run.scene, run.bodies, run.ns_per_step / 1000, run.speedup_over_all, run.speedup_over_moved,
        run.pairs, percent(pairs.at_rest), percent(pairs.separated), percent(pairs.recycled),
        percent(pairs.collided), run.contacts, per(run.memory.bodies, run.bodies),
        per(run.memory.pairs, run.pairs),
        run.afresh.steps > 0 ? std::to_string(run.afresh.mismatches) : "-");
  }
  return text;
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
