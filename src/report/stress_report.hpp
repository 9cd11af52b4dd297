#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "measure/stress/breaking_points.hpp"
#include "measure/stress/stress.hpp"
#include "report/gnuplot.hpp"

namespace manifuzz {

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

}  // namespace manifuzz
