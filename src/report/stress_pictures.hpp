#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "measure/stress/stress.hpp"
#include "report/plot/gnuplot.hpp"

namespace manifuzz {

/// Error against the knob, a line a collider: the larger of depth's and position's 99.9th
/// percentile, as a share of the size.
LinePlot plot_of(const StressPlan& plan, const StressResult& result, const Sweep& sweep);

/// The files that the plan's sweeps are drawn to in that folder; none where it is empty.
std::vector<std::string> stress_picture_files(const std::string& folder, const StressPlan& plan);

/// DIR/SWEEP.svg and DIR/SWEEP.png, where anything of the sweep was measured. Throws UserError.
void write_stress_pictures(const std::filesystem::path& folder, const StressPlan& plan,
                           const StressResult& result, const Sweep& sweep);

}  // namespace manifuzz
