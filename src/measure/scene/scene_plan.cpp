#include "measure/scene/scene_plan.hpp"

#include <fmt/format.h>

#include "corpus/corpus.hpp"

namespace manifuzz {

SceneResult run_scenes(const ScenePlan& plan,
                       const std::function<void(std::string_view doing, std::string_view scene,
                                                std::size_t bodies)>& on_scene) {
  SceneResult result;
  for (const SceneSpec* const spec : plan.scenes) {
    for (const std::size_t bodies : plan.sizes) {
      on_scene("timing", spec->name, bodies);
      const Trajectory trajectory = spec->make(bodies, plan.steps);
      result.runs.push_back(run_scene(spec->name, trajectory, plan.settings));
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
      finding.pair = pair;
      finding.note = fmt::format("In the scene {} of {} bodies it was not as it is afresh.",
                                 run.scene, run.bodies);
      write_corpus_case(corpus, finding);
    }
  }
}

}  // namespace manifuzz
