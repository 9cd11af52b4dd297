#pragma once

#include "measure/scene/scene_recycling.hpp"
#include "measure/scene/scene_run.hpp"
#include "report/plot/line_plot.hpp"
#include "report/plot/skip_plot.hpp"

namespace manifuzz {

/// What recycling costs a scene, a run a motion.
struct RecyclingCurve {
  std::string scene;
  std::size_t bodies = 0;
  std::vector<RecyclingRun> runs;
};

struct SceneReport {
  std::vector<SceneRun> runs;  ///< those of one scene follow each other
  std::vector<RecyclingCurve> curves;
};

/// The time of a step against the number of bodies, a line a scene with its fitted exponent.
LinePlot scaling_plot(const std::vector<SceneRun>& runs);

/// The error that recycling adds against the share of pairs that it skips, a line a scene.
LinePlot recycling_plot(const std::vector<RecyclingCurve>& curves);

/// Of each scene the run of the most bodies.
std::vector<SkipBar> skip_bars(const std::vector<SceneRun>& runs);

/// The curves for people.
std::string curves_table(const std::vector<RecyclingCurve>& curves);

nlohmann::ordered_json report_json(const SceneReport& report);

}  // namespace manifuzz
