#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "measure/bench/bench.hpp"
#include "measure/scene/scene_plan.hpp"
#include "measure/stress/breaking_points.hpp"
#include "measure/stress/stress.hpp"
#include "report/gnuplot.hpp"

namespace manifuzz {

// What `bench`, `stress` and `scene` print, write and draw.

/// "PROCESSOR, COMPILER" and an empty line, of what `bench_json` gave.
std::string machine_line(const nlohmann::ordered_json& json);

/// All rows for people.
std::string bench_table(const std::vector<BenchRow>& rows);

/// All rows with commas, a heading first.
std::string bench_csv(const std::vector<BenchRow>& rows);

/// Where the rows come from, and "rows": collider, query, input, target, vertices, touching,
/// regime, pairs, ns_per_pair, speedup_over_box2d, error, missed, phantom, cases.
nlohmann::ordered_json bench_json(const std::vector<BenchRow>& rows,
                                  const std::vector<BenchSubject>& subjects, std::uint64_t seed);

/// Run time against error over the first workload, a point for each that gives manifolds.
PointPlot bench_plot(const std::vector<BenchRow>& rows);

/// Sweep by collider: breaking points; then the walks. For people.
std::string stress_table(const StressPlan& plan, const StressResult& result);

/// How far a run is, and how long it takes from there.
std::string progress_line(const StressProgress& progress);

/// What decides the status, in words: nothing where no breaking point is worse than stored and
/// every one was compared.
std::string complaints(const Comparison& comparison);

/// Where it was measured, the plan's terms, the comparison, and the arrays "sweeps" and "walks".
nlohmann::ordered_json stress_json(const StressPlan& plan, const StressResult& result,
                                   const Comparison& comparison);

/// Every step with commas, then the walks, a heading first; columns that are not for a row are
/// empty.
std::string stress_csv(const StressPlan& plan, const StressResult& result);

/// Error against the knob, a line a collider: the larger of depth's and position's 99.9th
/// percentile, as a share of the size.
LinePlot plot_of(const StressPlan& plan, const StressResult& result, const Sweep& sweep);

/// The files that the plan's sweeps are drawn to in that folder; none where it is empty.
std::vector<std::string> stress_picture_files(const std::string& folder, const StressPlan& plan);

/// DIR/SWEEP.svg and DIR/SWEEP.png, where anything of the sweep was measured. Throws UserError.
void write_stress_pictures(const std::filesystem::path& folder, const StressPlan& plan,
                           const StressResult& result, const Sweep& sweep);

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
