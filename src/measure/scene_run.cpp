#include "measure/scene_run.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>

#include <fmt/format.h>

#include "kernel/batch.hpp"
#include "measure/scene_player.hpp"

namespace manifuzz {
namespace {

/// Up to so many bodies, every step is held against all pairs afresh.
constexpr std::size_t kAfreshBodiesMax = 1000;

constexpr std::size_t kFindingsMax = 16;

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

template <class Work>
double ns_of(const Work& work) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  work();
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
}

/// Every pair of bodies, collided by the kernel that the scene uses.
class Afresh {
 public:
  explicit Afresh(const Trajectory& trajectory)
      : polygons_(trajectory.shapes), placements_(trajectory.start) {
    for (const auto& shape : trajectory.shapes) shapes_.add(shape);
    const auto count = static_cast<std::uint32_t>(placements_.size());
    for (std::uint32_t a = 0; a < count; ++a) {
      for (std::uint32_t b = a + 1; b < count; ++b) pairs_.push_back({a, b});
    }
    manifolds_.resize(pairs_.size());
  }

  void move(std::span<const BodyMove> moves) {
    for (const BodyMove& move : moves) placements_[move.body].pose = move.pose;
  }

  /// The pairs whose contacts differ; bodies' handles have their indices.
  std::vector<kernel::BodyPair> mismatches(std::span<const scene::Contact> contacts) {
    kernel::collide_pairs(shapes_, placements_, pairs_, 0, manifolds_);
    std::map<std::pair<std::uint32_t, std::uint32_t>, const Manifold<float>*> right;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      if (manifolds_[i].count > 0) right[{pairs_[i].a, pairs_[i].b}] = &manifolds_[i];
    }
    std::vector<kernel::BodyPair> wrong;
    for (const scene::Contact& contact : contacts) {
      const kernel::BodyPair bodies{contact.a.index, contact.b.index};
      const auto found = right.find({bodies.a, bodies.b});
      if (found == right.end() || !(*found->second == contact.manifold)) wrong.push_back(bodies);
      if (found != right.end()) right.erase(found);
    }
    for (const auto& [bodies, manifold] : right) wrong.push_back({bodies.first, bodies.second});
    return wrong;
  }

  /// The pair as it is now.
  PairCase pair(const kernel::BodyPair& bodies) const {
    const auto body = [&](std::uint32_t i) {
      return Body{polygons_[placements_[i].shape], placements_[i].pose};
    };
    return {body(bodies.a), body(bodies.b)};
  }

 private:
  std::vector<ConvexPolygon<float>> polygons_;
  kernel::Shapes<float> shapes_;
  std::vector<kernel::Placement<float>> placements_;
  std::vector<kernel::BodyPair> pairs_;
  std::vector<Manifold<float>> manifolds_;
};

/// The three that go through a trajectory.
class Race {
 public:
  Race(const Trajectory& trajectory, const scene::Settings& settings)
      : ours_(trajectory, settings) {
    std::vector<Body> bodies;
    for (std::size_t i = 0; i < trajectory.start.size(); ++i) bodies.push_back(trajectory.body(i));
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
  sum.bodies += counts.bodies;
  sum.moved += counts.moved;
  sum.left_boxes += counts.left_boxes;
  sum.pairs_added += counts.pairs_added;
  sum.pairs_dropped += counts.pairs_dropped;
  sum.proofs += counts.proofs;
}

/// Holds a scene against every pair afresh. Apart from what is timed: it would empty the caches.
void look_for_mismatches(const Trajectory& trajectory, const scene::Settings& settings,
                         SceneRun& run) {
  ScenePlayer player(trajectory, settings);
  Afresh afresh(trajectory);
  run.mismatches = 0;
  for (const auto& moves : trajectory.steps) {
    afresh.move(moves);
    const auto wrong = afresh.mismatches(player.step(moves).contacts);
    *run.mismatches += wrong.size();
    for (const kernel::BodyPair& bodies : wrong) {
      if (run.findings.size() < kFindingsMax) run.findings.push_back(afresh.pair(bodies));
    }
  }
}

}  // namespace

SceneRun run_scene(std::string_view name, const Trajectory& trajectory,
                   const scene::Settings& settings) {
  SceneRun run;
  run.scene = name;
  run.bodies = trajectory.start.size();
  run.steps = trajectory.steps.size();
  run.recycled_motion = settings.recycled_motion;
  const bool is_strict = settings.recycled_motion == 0;
  if (is_strict && run.bodies <= kAfreshBodiesMax) look_for_mismatches(trajectory, settings, run);
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

Frame last_frame(const Trajectory& trajectory) {
  Frame frame;
  for (std::size_t i = 0; i < trajectory.start.size(); ++i) {
    frame.bodies.push_back(trajectory.body(i));
  }
  for (const auto& moves : trajectory.steps) {
    for (const BodyMove& move : moves) frame.bodies[move.body].pose = move.pose;
  }
  ScenePlayer player(trajectory, {});
  scene::StepResult last;
  for (const auto& moves : trajectory.steps) last = player.step(moves);
  frame.contacts.assign(last.contacts.begin(), last.contacts.end());
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
  if (run.mismatches) json["mismatches"] = *run.mismatches;
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
        per(run.memory.pairs, run.pairs), run.mismatches ? std::to_string(*run.mismatches) : "-");
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
