#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "afresh/afresh.hpp"
#include "engines/engine.hpp"
#include "kernel/packed.hpp"
#include "measure/referee.hpp"
#include "scene/scene.hpp"
#include "scene/threads.hpp"

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

/// Puts bodies where the trajectory has them now, whatever a scene makes of it.
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

/// A scene with a trajectory's bodies, which have the same indices there.
class ScenePlayer {
 public:
  ScenePlayer(const Trajectory& trajectory, const scene::Settings& settings,
              const scene::Executor& executor = {})
      : scene_(settings), executor_(executor) {
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
    const auto stepped = scene_.step(moves_, executor_);
    result_ = std::get<scene::StepResult>(stepped);
    return result_;
  }

  const scene::StepResult& result() const { return result_; }
  const scene::Scene& scene() const { return scene_; }

 private:
  scene::Scene scene_;
  scene::Executor executor_;
  std::vector<scene::BodyHandle> handles_;
  std::vector<scene::Move> moves_;
  scene::StepResult result_;
};

/// A trajectory's bodies, all pairs afresh in each step.
class AfreshPlayer {
 public:
  AfreshPlayer(const Trajectory& trajectory, const scene::Settings& settings)
      : afresh_(settings.tie_bias), bodies_(trajectory.start) {
    for (const auto& shape : trajectory.shapes) afresh_.add_shape(shape);
    step({});
  }

  /// Valid until the next one.
  std::span<const scene::Touching> step(std::span<const BodyMove> moves) {
    for (const BodyMove& move : moves) bodies_[move.body].pose = move.pose;
    return afresh_.collide(bodies_);
  }

 private:
  scene::Afresh afresh_;
  std::vector<kernel::Placement<float>> bodies_;
};

/// What recycling up to a motion skips in a scene, and how good the contacts are then.
struct RecyclingRun {
  float motion = 0;        ///< scene::Settings::recycled_motion; 0 is strict
  double skipped = 0;      ///< the share of strict mode's collisions that it spares
  ErrorStatistics errors;  ///< of a sample of the contacts, spread over all steps
};

/// What recycling costs in one scene, a run a motion.
struct RecyclingCurve {
  std::string scene;
  std::size_t bodies = 0;
  std::vector<RecyclingRun> runs;
};

/// The motions of a curve: lengths, in scenes of bodies about 1 wide. Strict mode comes first.
inline constexpr std::array<float, 8> kRecyclingMotions{0,     0.0003F, 0.001F, 0.003F,
                                                        0.01F, 0.03F,   0.1F,   0.3F};

/// A run a motion.
std::vector<RecyclingRun> run_recycling(const Trajectory& trajectory);

/// What a strict scene's contacts, and those of `scene::Afresh`, were held against: every pair of
/// bodies, collided.
struct AfreshCheck {
  std::size_t steps = 0;           ///< those that were held against it, spread over the trajectory
  std::size_t mismatches = 0;      ///< contacts that differ by a bit, are missing or too many
  std::vector<PairCase> findings;  ///< the first of them
};

/// As many steps as 60 million pairs allow: all for 1,000 bodies and 100 steps, one for 10,000,
/// none for more.
AfreshCheck check_afresh(const Trajectory& trajectory, const scene::Settings& settings);

/// What a scene is held against, step by step.
struct BaselineRun {
  std::string name;
  double ns_per_step = 0;               ///< the median of the steps
  double speedup = 0;                   ///< of the scene over it: the median of the steps' ratios
  std::optional<std::size_t> contacts;  ///< that touch after the last step, where it says so
};

/// A trajectory gone through by a scene and by baselines, step by step in turn: Box2D's broad phase
/// and its `b2CollidePolygons` on every pair (all), or on those of which a body moved (moved),
/// `scene::Afresh`, and worlds of installed engines.
struct SceneRun {
  std::string scene;
  std::size_t bodies = 0;
  std::size_t steps = 0;
  float recycled_motion = 0;  ///< 0 is strict
  bool certificates = true;   ///< scene::Settings::certificates
  std::size_t threads = 1;    ///< that the steps were run on
  double ns_per_step = 0;     ///< the median of the steps
  BaselineRun over_all;       ///< Box2D's, on every pair
  BaselineRun over_afresh;    ///< `scene::Afresh`
  std::vector<BaselineRun> over_worlds;
  double speedup_over_moved = 0;       ///< the median of the steps' ratios
  double speedup_over_alone = 1;       ///< over one thread, likewise
  double warm_speedup_over_alone = 1;  ///< likewise, where no baseline steps between
  double afresh_over_all = 0;          ///< how many times as fast as Box2D that is, likewise
  scene::StepCounts counts;            ///< sums over the steps
  std::size_t contacts = 0;            ///< after the last step
  std::size_t pairs = 0;               ///< candidates after the last step
  scene::Memory memory;                ///< after the last step
  AfreshCheck afresh;                  ///< of no step where contacts are recycled
};

/// The first step, in which everything is new, is not counted.
SceneRun run_scene(std::string_view name, const Trajectory& trajectory,
                   const scene::Settings& settings, std::size_t threads = 1);

/// Bodies in the world, and how they touch; their handles have the bodies' indices.
struct Frame {
  std::vector<Body> bodies;
  std::vector<scene::Contact> contacts;
};

/// As a trajectory leaves them.
Frame last_frame(const Trajectory& trajectory, const scene::Settings& settings);

/// The exponent k of y ~ x^k that fits points best, in logarithms; none for fewer than two x.
std::optional<double> fitted_exponent(const std::vector<std::pair<double, double>>& points);

/// Each of these scenes at each number of bodies.
struct ScenePlan {
  std::vector<const SceneSpec*> scenes;
  std::vector<std::size_t> sizes;  ///< numbers of bodies, rising
  int steps = 30;
  scene::Settings settings;
  std::size_t threads = 1;  ///< that strict steps run on
  bool has_curves = false;  ///< recycling at every motion as well, at the least number of bodies
};

struct SceneResult {
  std::vector<SceneRun> runs;  ///< those of one scene follow each other
  std::vector<RecyclingCurve> curves;
};

/// `on_scene` is told what comes next: "timing" or "recycling", of which scene, how many bodies.
SceneResult run_scenes(const ScenePlan& plan,
                       const std::function<void(std::string_view doing, std::string_view scene,
                                                std::size_t bodies)>& on_scene);

/// Writes the pairs that were not as they are afresh to a corpus, whose cases the tests put into
/// scenes. Throws UserError.
void save_mismatches(const std::filesystem::path& corpus, const std::vector<SceneRun>& runs);

}  // namespace manifuzz
