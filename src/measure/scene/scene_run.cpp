#include "measure/scene/scene_run.hpp"

#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "corpus/corpus.hpp"
#include "own_colliders/own_colliders.hpp"

namespace manifuzz {
namespace {

/// Judging one takes about a hundred times as long as colliding it.
constexpr std::size_t kJudged = 2000;

/// How many pairs were collided, and how good the contacts are: one in so many, whatever the step.
std::pair<std::size_t, ErrorStatistics> recycled_at(const Trajectory& trajectory, float motion) {
  const Declaration declaration = make_batch(0).declaration;
  ScenePlayer player(trajectory, {.recycled_motion = motion});
  const std::size_t contacts = player.result().contacts.size();
  const std::size_t every = 1 + contacts * trajectory.steps.size() / kJudged;
  std::size_t seen = 0;
  std::size_t collided = 0;
  ErrorCollector errors;
  std::vector<Body> bodies = trajectory.bodies();
  for (const auto& moves : trajectory.steps) {
    move_bodies(moves, bodies);
    collided += player.step(moves).counts.pairs.collided;
    for (const scene::Contact& contact : player.result().contacts) {
      if (seen++ % every != 0) continue;
      Referee referee({bodies[contact.a.index], bodies[contact.b.index]});
      const Answer answer = manifold_cast<double>(contact.manifold);
      errors.add(seen, referee.measure(declaration, referee.whole(declaration, answer)));
    }
  }
  return {collided, errors.statistics()};
}

}  // namespace

std::vector<RecyclingRun> run_recycling(const Trajectory& trajectory) {
  std::vector<RecyclingRun> runs;
  std::size_t strict = 0;
  for (const float motion : kRecyclingMotions) {
    const auto [collided, errors] = recycled_at(trajectory, motion);
    if (motion == 0) strict = collided;
    const double kept =
        strict == 0 ? 1 : static_cast<double>(collided) / static_cast<double>(strict);
    runs.push_back({motion, 1 - kept, errors});
  }
  return runs;
}

namespace {

template <class Work>
double ns_of(const Work& work) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  work();
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
}

/// The times of a step; who begins changes by step.
struct StepTimes {
  double ours = 0;
  double alone = 0;  ///< ours on one thread
  double all = 0;
  double moved = 0;
  double afresh = 0;
};

StepTimes times_of(std::span<const BodyMove> moves, std::size_t step, ScenePlayer& ours,
                   ScenePlayer* alone, ScenePairs& all, ScenePairs& moved, AfreshPlayer& afresh) {
  ours.prepare(moves);
  if (alone != nullptr) alone->prepare(moves);
  StepTimes ns;
  const std::size_t players = alone == nullptr ? 4 : 5;
  for (std::size_t i = 0; i < players; ++i) {
    const std::size_t turn = (step + i) % players;
    if (turn == 0) ns.ours = ns_of([&] { ours.step_prepared(); });
    if (turn == 1) ns.all = ns_of([&] { all.step(moves, false); });
    if (turn == 2) ns.moved = ns_of([&] { moved.step(moves, true); });
    if (turn == 3) ns.afresh = ns_of([&] { afresh.step(moves); });
    if (turn == 4) ns.alone = ns_of([&] { alone->step_prepared(); });
  }
  if (alone == nullptr) ns.alone = ns.ours;
  return ns;
}

void add_to(scene::StepCounts& sum, const scene::StepCounts& counts) {
  sum.pairs.at_rest += counts.pairs.at_rest;
  sum.pairs.separated += counts.pairs.separated;
  sum.pairs.recycled += counts.pairs.recycled;
  sum.pairs.collided += counts.pairs.collided;
  sum.pairs.candidates += counts.pairs.candidates;
  sum.moved += counts.moved;
  sum.left_boxes += counts.left_boxes;
  sum.pairs_added += counts.pairs_added;
  sum.pairs_dropped += counts.pairs_dropped;
  sum.proofs += counts.proofs;
}

}  // namespace

SceneRun run_scene(std::string_view name, const Trajectory& trajectory,
                   const scene::Settings& settings, std::size_t threads) {
  SceneRun run;
  run.threads = threads;
  run.scene = name;
  run.bodies = trajectory.start.size();
  run.steps = trajectory.steps.size();
  run.recycled_motion = settings.recycled_motion;
  run.certificates = settings.certificates;
  // Apart from what is timed: it would empty the caches.
  if (settings.recycled_motion == 0) run.afresh = check_afresh(trajectory, settings);
  scene::Threads pool(threads);
  const bool is_divided = threads > 1;
  ScenePlayer ours(trajectory, settings,
                   is_divided ? scene::Executor(std::ref(pool)) : scene::Executor());
  std::optional<ScenePlayer> alone;
  if (is_divided) alone.emplace(trajectory, settings);
  const auto all = scene_baseline().pairs(trajectory.bodies());
  const auto moved = scene_baseline().pairs(trajectory.bodies());
  all->step({}, false);
  moved->step({}, true);
  AfreshPlayer afresh(trajectory, settings);
  std::vector<StepTimes> times;
  for (std::size_t step = 0; step < run.steps; ++step) {
    times.push_back(times_of(trajectory.steps[step], step, ours, alone ? &*alone : nullptr, *all,
                             *moved, afresh));
    add_to(run.counts, ours.result().counts);
  }
  const auto median_of = [&](auto&& value) {
    std::vector<double> values;
    for (const StepTimes& ns : times) values.push_back(value(ns));
    return median(values);
  };
  run.ns_per_step = median_of([](const StepTimes& ns) { return ns.ours; });
  run.afresh_ns_per_step = median_of([](const StepTimes& ns) { return ns.afresh; });
  run.speedup_over_all = median_of([](const StepTimes& ns) { return ns.all / ns.ours; });
  run.speedup_over_moved = median_of([](const StepTimes& ns) { return ns.moved / ns.ours; });
  run.speedup_over_afresh = median_of([](const StepTimes& ns) { return ns.afresh / ns.ours; });
  run.speedup_over_alone = median_of([](const StepTimes& ns) { return ns.alone / ns.ours; });
  run.afresh_over_all = median_of([](const StepTimes& ns) { return ns.all / ns.afresh; });
  run.contacts = ours.result().contacts.size();
  run.pairs = ours.scene().pair_count();
  run.memory = ours.scene().memory();
  return run;
}

Frame last_frame(const Trajectory& trajectory, const scene::Settings& settings) {
  ScenePlayer player(trajectory, settings);
  std::vector<Body> bodies = trajectory.bodies();
  for (const auto& moves : trajectory.steps) player.step(moves);
  for (const auto& moves : trajectory.steps) move_bodies(moves, bodies);
  const auto contacts = player.result().contacts;
  return {bodies, {contacts.begin(), contacts.end()}};
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

SceneResult run_scenes(const ScenePlan& plan,
                       const std::function<void(std::string_view doing, std::string_view scene,
                                                std::size_t bodies)>& on_scene) {
  SceneResult result;
  for (const SceneSpec* const spec : plan.scenes) {
    for (const std::size_t bodies : plan.sizes) {
      on_scene("timing", spec->name, bodies);
      const Trajectory trajectory = spec->make(bodies, plan.steps);
      result.runs.push_back(run_scene(spec->name, trajectory, plan.settings, plan.threads));
    }
  }
  if (!plan.has_curves) return result;
  for (const SceneSpec* const spec : plan.scenes) {
    const std::size_t bodies = plan.sizes.front();
    on_scene("recycling", spec->name, bodies);
    const Trajectory trajectory = spec->make(bodies, plan.steps);
    result.curves.push_back(
        {std::string(spec->name), trajectory.start.size(), run_recycling(trajectory)});
  }
  return result;
}

void save_mismatches(const std::filesystem::path& corpus, const std::vector<SceneRun>& runs) {
  for (const SceneRun& run : runs) {
    for (const PairCase& pair : run.afresh.findings) {
      CorpusCase finding;
      finding.any = pair;
      finding.note = fmt::format("In the scene {} of {} bodies it was not as it is afresh.",
                                 run.scene, run.bodies);
      write_corpus_case(corpus, finding);
    }
  }
}

}  // namespace manifuzz
