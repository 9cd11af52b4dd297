#include "measure/scene/scene_run.hpp"

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
