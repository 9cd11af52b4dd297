#include <chrono>
#include <deque>
#include <thread>

#include "engines/asked_engines.hpp"
#include "external/timed_world.hpp"
#include "measure/scene/scene_run.hpp"
#include "measure/scene/turns.hpp"

namespace manifuzz {
namespace {

using Moves = std::span<const BodyMove>;

template <class Work>
double ns_of(const Work& work) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  work();
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
}

/// Who goes through a trajectory, and the times of its steps.
struct Contender {
  std::function<double(Moves)> step;             ///< gives what it took, ns
  std::function<void(Moves)> prepare = nullptr;  ///< before any of them steps, not timed
  std::vector<double> ns{};
};

/// How many times as fast as `other` it is: the median of the steps' ratios.
double speedup(const Contender& one, const Contender& other) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < one.ns.size(); ++i) ratios.push_back(other.ns[i] / one.ns[i]);
  return median(ratios);
}

Contender contender(ScenePlayer& player) {
  return {.step = [&player](Moves) { return ns_of([&] { player.step_prepared(); }); },
          .prepare = [&player](Moves moves) { player.prepare(moves); }};
}

Contender contender(ScenePairs& pairs, bool skip_unmoved) {
  pairs.step({}, skip_unmoved);
  return {.step = [&pairs, skip_unmoved](Moves moves) {
    return ns_of([&] { pairs.step(moves, skip_unmoved); });
  }};
}

Contender contender(AfreshPlayer& player) {
  return {.step = [&player](Moves moves) { return ns_of([&] { player.step(moves); }); }};
}

/// An engine's world, by the engine's own clock.
class WorldPlayer {
 public:
  WorldPlayer(const EngineTimedWorld& world, std::span<const Body> bodies)
      : name_(world.name), world_(world.library, world.name, bodies) {
    world_.step({});
  }

  const std::string& name() const { return name_; }
  double step_prepared() { return world_.step(moves_); }
  void prepare(Moves moves) {
    moves_.clear();
    for (const auto& [body, pose] : moves) {
      const Vector2<float>& position = pose.position;
      const Vector2<float>& rotation = pose.rotation;
      moves_.push_back({body, {position.x(), position.y()}, {rotation.x(), rotation.y()}});
    }
  }
  std::size_t contacts() { return world_.contacts(); }

 private:
  std::string name_;
  TimedWorld world_;
  std::vector<manifuzz_move> moves_;
};

Contender contender(WorldPlayer& player) {
  return {.step = [&player](Moves) { return player.step_prepared(); },
          .prepare = [&player](Moves moves) { player.prepare(moves); }};
}

/// One step of all, in the order of their turns.
void take_turns(std::span<Contender* const> all, Moves moves, std::size_t step) {
  for (Contender* const one : all) {
    if (one->prepare) one->prepare(moves);
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    Contender& one = *all[whose_turn(step, i, all.size())];
    one.ns.push_back(one.step(moves));
  }
}

/// Threads do not sleep while others step, if each has a core or a hardware thread of one: to wake
/// one takes a virtual machine a good part of a step, and its core's caches are no longer its own
/// then.
scene::Idle idle_of(std::size_t threads) {
  return threads <= std::thread::hardware_concurrency() ? scene::Idle::spin : scene::Idle::sleep;
}

/// How many times as fast so many threads are as one where nobody else steps: what both need stays
/// in the caches that cores share, as far as it fits.
double warm_speedup(const Trajectory& trajectory, const scene::Settings& settings,
                    std::size_t threads) {
  scene::Threads pool(threads, idle_of(threads));
  ScenePlayer together(trajectory, settings, std::ref(pool));
  ScenePlayer alone(trajectory, settings);
  Contender by_threads = contender(together);
  Contender by_one = contender(alone);
  Contender* const both[] = {&by_threads, &by_one};
  for (std::size_t step = 0; step < trajectory.steps.size(); ++step) {
    take_turns(both, trajectory.steps[step], step);
  }
  return speedup(by_threads, by_one);
}

/// A scene and all that it is held against.
class Contest {
 public:
  Contest(const Trajectory& trajectory, const scene::Settings& settings, std::size_t threads)
      : pool_(threads, idle_of(threads)),
        ours_(trajectory, settings,
              threads > 1 ? scene::Executor(std::ref(pool_)) : scene::Executor()),
        all_(scene_engine().scenes.pairs(trajectory.bodies())),
        moved_(scene_engine().scenes.pairs(trajectory.bodies())),
        afresh_(trajectory, settings),
        by_ours_(contender(ours_)),
        by_all_(contender(*all_, false)),
        by_moved_(contender(*moved_, true)),
        by_afresh_(contender(afresh_)) {
    if (threads > 1) {
      alone_.emplace(trajectory, settings);
      by_alone_ = contender(*alone_);
    }
    for (const EngineTimedWorld& world : installed_timed_worlds()) {
      by_worlds_.push_back(contender(worlds_.emplace_back(world, trajectory.bodies())));
    }
  }
  Contest& operator=(Contest&&) = delete;  // neither moved nor copied

  /// One step of all.
  void step(Moves moves, std::size_t step) {
    std::vector<Contender*> all{&by_ours_, &by_all_, &by_moved_, &by_afresh_};
    if (by_alone_) all.push_back(&*by_alone_);
    for (Contender& world : by_worlds_) all.push_back(&world);
    take_turns(all, moves, step);
  }

  const ScenePlayer& ours() const { return ours_; }

  /// Fills in what came of all steps.
  void tell(SceneRun& run) {
    run.ns_per_step = median(by_ours_.ns);
    run.over_all = over(scene_engine().name, by_all_, {});
    run.over_afresh = over("afresh", by_afresh_, afresh_.step({}).size());
    for (std::size_t i = 0; i < worlds_.size(); ++i) {
      run.over_worlds.push_back(over(worlds_[i].name(), by_worlds_[i], worlds_[i].contacts()));
    }
    run.speedup_over_moved = speedup(by_ours_, by_moved_);
    if (by_alone_) run.speedup_over_alone = speedup(by_ours_, *by_alone_);
    run.afresh_over_all = speedup(by_afresh_, by_all_);
  }

 private:
  BaselineRun over(std::string_view name, const Contender& other,
                   std::optional<std::size_t> contacts) const {
    return {std::string(name), median(other.ns), speedup(by_ours_, other), contacts};
  }

  scene::Threads pool_;
  ScenePlayer ours_;
  std::unique_ptr<ScenePairs> all_;
  std::unique_ptr<ScenePairs> moved_;
  AfreshPlayer afresh_;
  std::optional<ScenePlayer> alone_;
  std::deque<WorldPlayer> worlds_;
  Contender by_ours_;
  Contender by_all_;
  Contender by_moved_;
  Contender by_afresh_;
  std::optional<Contender> by_alone_;
  std::vector<Contender> by_worlds_;
};

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
  if (threads > 1) run.warm_speedup_over_alone = warm_speedup(trajectory, settings, threads);
  Contest contest(trajectory, settings, threads);
  for (std::size_t step = 0; step < run.steps; ++step) {
    contest.step(trajectory.steps[step], step);
    add_to(run.counts, contest.ours().result().counts);
  }
  contest.tell(run);
  run.contacts = contest.ours().result().contacts.size();
  run.pairs = contest.ours().scene().pair_count();
  run.memory = contest.ours().scene().memory();
  return run;
}

}  // namespace manifuzz
