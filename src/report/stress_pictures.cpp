#include "report/stress_pictures.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "base/text.hpp"
#include "base/user_error.hpp"

namespace manifuzz {
namespace {

/// Logarithmic axes have no 0: the last step of a sweep by ulps is drawn at half an ulp.
double drawn_at(double value) {
  return value > 0 ? value : 0.5;
}

PlotLine line_of(const Sweep& sweep, const StressSubject& subject,
                 const std::vector<StepStatistics>& steps) {
  PlotLine line{.name = subject.name, .points = {}, .breaks_at = {}};
  line.is_ideal = subject.name == kIdealName;
  if (line.is_ideal) line.name = "the truth, rounded to float";
  const auto breaking = breaking_step(steps);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const bool breaks_here = i == breaking && !line.is_ideal;
    if (steps[i].contacts == 0 && !breaks_here) continue;
    if (breaks_here) line.breaks_at = line.points.size();
    const ErrorSpreads& of_size = steps[i].of_size;
    line.points.emplace_back(drawn_at(sweep.values[i]),
                             std::max(of_size.depth.p999, of_size.position.p999));
  }
  return line;
}

std::array<std::string, 2> files_of(const std::filesystem::path& folder, const Sweep& sweep) {
  const auto file = [&](const char* ending) {
    return (folder / fmt::format("{}.{}", sweep.name, ending)).string();
  };
  return {file("svg"), file("png")};
}

}  // namespace

LinePlot plot_of(const StressPlan& plan, const StressResult& result, const Sweep& sweep) {
  const bool has_zero = sweep.values.back() == 0;
  LinePlot plot{.title = fmt::format("{}: {}", sweep.name, sweep.description),
                .x_label = fmt::format("{} ({}){}", sweep.knob, sweep.unit,
                                       has_zero ? "; 0 is drawn at 0.5" : ""),
                .y_label = "error of depth or position, 99.9%, share of the size",
                .falls = sweep.values.back() < sweep.values.front(),
                .limit = kGrossShare,
                .lines = {}};
  for (std::size_t i = 0; i < plan.subjects.size(); ++i) {
    if (plan.subjects[i].walks_only) continue;
    const auto steps = result.steps(sweep, i);
    if (!steps.empty()) plot.lines.push_back(line_of(sweep, plan.subjects[i], steps));
  }
  return plot;
}

std::vector<std::string> stress_picture_files(const std::string& folder, const StressPlan& plan) {
  std::vector<std::string> files;
  if (folder.empty()) return files;
  for (const Sweep* const sweep : plan.sweeps) {
    for (std::string& file : files_of(folder, *sweep)) files.push_back(std::move(file));
  }
  return files;
}

void write_stress_pictures(const std::filesystem::path& folder, const StressPlan& plan,
                           const StressResult& result, const Sweep& sweep) {
  const LinePlot plot = plot_of(plan, result, sweep);
  if (plot.lines.empty()) return;
  for (const std::string& file : files_of(folder, sweep)) write_plot(file, plot);
}

}  // namespace manifuzz
