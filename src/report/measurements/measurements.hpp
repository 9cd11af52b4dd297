#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "measure/bench/bench.hpp"
#include "measure/digest.hpp"
#include "measure/methods/methods.hpp"
#include "measure/scene/scene_run.hpp"
#include "measure/stress/stress.hpp"

namespace manifuzz {

// Pictures drawn by gnuplot. Each function throws UserError where the file's name does not end in
// .svg or .png, where gnuplot is missing, or where the file cannot be written.

/// Runs gnuplot's commands, which draw one picture.
void draw_plot(const std::string& path, const std::string& commands);

/// One thing against a knob.
struct PlotLine {
  std::string name;
  std::vector<std::pair<double, double>> points;  ///< y 0 or more; x above 0 if logarithmic
  std::optional<std::size_t> breaks_at;           ///< the point that is marked
  bool is_ideal = false;                          ///< drawn as a thin dashed line, for comparison
};

struct LinePlot {
  std::string title;
  std::string x_label;
  std::string y_label;
  bool is_linear_in_x = false;
  bool falls = false;             ///< the axis of x runs from the largest to the smallest
  std::optional<double> limit{};  ///< a level line: above it a line has broken
  std::vector<PlotLine> lines{};
};

/// Lines of equal points as one, with their names: colliders often answer alike.
std::vector<PlotLine> merged(std::vector<PlotLine> lines);

/// Draws the merged lines, y logarithmic and x too unless it is linear.
void write_plot(const std::string& path, const LinePlot& plot);

// What `bench`, `stress` and `scene` print, write and draw.

/// "PROCESSOR, COMPILER" and an empty line, of what `bench_json` gave.
std::string machine_line(const nlohmann::ordered_json& json);

/// All rows for people.
std::string bench_table(const std::vector<BenchRow>& rows);

/// Where the rows come from, and "rows": collider, query, input, target, vertices, touching,
/// regime, pairs, ns_per_pair, speedup_over_box2d, error, missed, phantom, cases.
nlohmann::ordered_json bench_json(const std::vector<BenchRow>& rows,
                                  const std::vector<BenchSubject>& subjects, std::uint64_t seed);

/// A named point on two logarithmic axes: coordinates above 0.
struct PlotPoint {
  std::string name;
  double x = 0;
  double y = 0;
};

/// The points that no other is left of and below, by x.
std::vector<PlotPoint> front(std::vector<PlotPoint> points);

/// Draws run time against error over the first workload, a point for each that gives manifolds,
/// and their front as a line.
void write_bench_plot(const std::string& path, const std::vector<BenchRow>& rows);

/// The ways to contact points beside each other, for people: by pairs and frames, then by vertices
/// and depths.
std::string methods_table(const std::vector<MethodRow>& rows);

/// Where the rows come from, and "rows": as `bench_json` has them, with method, depths,
/// points_missing, extent_lost, and of frames frames_to_complete, completed, lingering, flicker.
nlohmann::ordered_json methods_json(const std::vector<MethodRow>& rows,
                                    const std::vector<MethodSubject>& subjects, std::uint64_t seed);

/// Draws a bar a subject for each of what frames show: time, depth error, extent lost, frames until
/// complete, flicker.
void write_methods_plot(const std::string& path, const std::vector<MethodRow>& rows);

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

/// DIR/SWEEP.svg and DIR/SWEEP.png.
std::array<std::string, 2> stress_picture_files(const std::filesystem::path& folder,
                                                const Sweep& sweep);

/// Draws these, where anything of the sweep was measured: error against the knob, a line a
/// collider, the larger of depth's and position's 99.9th percentile as a share of the size. Throws
/// UserError.
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

/// Draws where the pairs went, of each scene the run of the most bodies: at rest, proven separated,
/// recycled, collided.
void write_skipped_plot(const std::string& path, const std::vector<SceneRun>& runs);

/// The error that recycling adds against the share of pairs that it skips, a line a scene.
LinePlot recycling_plot(const std::vector<RecyclingCurve>& curves);

/// A hash for each regime and one over all, for people and as JSON beside where it was measured.
std::string digest_table(const DigestPlan& plan, const Digest& digest);
nlohmann::ordered_json digest_json(const DigestPlan& plan, const Digest& digest);

/// The last step of the first scene, at its least number of bodies, as an SVG document.
std::string scene_frame(const ScenePlan& plan);

}  // namespace manifuzz
