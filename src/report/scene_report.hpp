#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "measure/scene/scene_plan.hpp"
#include "report/gnuplot.hpp"

namespace manifuzz {

/// Rows and curves for people.
std::string scene_table(const SceneResult& result);

/// What decides the status, in words.
std::string mismatches_in_words(const std::vector<SceneRun>& runs);

/// Where it was measured, and "rows", "exponents" and "recycling".
nlohmann::ordered_json scene_json(const SceneResult& result);

/// The time of a step against the number of bodies, a line a scene with its fitted exponent.
LinePlot scaling_plot(const std::vector<SceneRun>& runs);

/// Of each scene the run of the most bodies: at rest, proven separated, recycled, collided.
BarPlot skipped_plot(const std::vector<SceneRun>& runs);

/// The error that recycling adds against the share of pairs that it skips, a line a scene.
LinePlot recycling_plot(const std::vector<RecyclingCurve>& curves);

/// The last step of the first scene, at its least number of bodies, as an SVG document.
std::string scene_frame(const ScenePlan& plan);

}  // namespace manifuzz
