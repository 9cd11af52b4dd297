#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text.hpp"
#include "report/measurements.hpp"

namespace manifuzz {
namespace {

/// The subjects that have a row or a column: sweeps are not for the variants, and the ideal is no
/// collider.
std::vector<std::size_t> reported_subjects(const StressPlan& plan, bool in_walks) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < plan.subjects.size(); ++i) {
    const StressSubject& subject = plan.subjects[i];
    if (subject.name != kIdealName && (in_walks || !subject.walks_only)) numbers.push_back(i);
  }
  return numbers;
}

std::string unbroken(const Sweep& sweep, const std::vector<StepStatistics>& steps) {
  if (steps.size() < sweep.values.size()) return fmt::format("({} steps)", steps.size());
  const auto has_contact = [](const StepStatistics& step) { return step.contacts > 0; };
  return std::ranges::any_of(steps, has_contact) ? "never" : "-";
}

std::string row_of_breaking_points(const StressPlan& plan, const StressResult& result,
                                   const Sweep& sweep) {
  std::string row = fmt::format("{:<10}", sweep.name);
  for (const std::size_t i : reported_subjects(plan, false)) {
    const auto steps = result.steps(sweep, i);
    const auto step = breaking_step(steps);
    row += fmt::format(" {:>13}",
                       step ? fmt::format("{:g}", sweep.values[*step]) : unbroken(sweep, steps));
  }
  return row + fmt::format("  {}\n", sweep.unit);
}

/// A row under the table that says something of each collider to which it applies; none where it
/// applies to nobody. `said(steps)` is nothing where it does not.
template <class Said>
std::string row_of_remarks(const StressPlan& plan, const StressResult& result, const Sweep& sweep,
                           std::string_view what, const Said& said) {
  std::vector<std::string> remarks;
  for (const std::size_t i : reported_subjects(plan, false)) {
    const std::string remark = said(result.steps(sweep, i));
    if (!remark.empty()) remarks.push_back(plan.subjects[i].name + " " + remark);
  }
  if (remarks.empty()) return {};
  return fmt::format("{}: {}: {}\n", sweep.name, what, fmt::join(remarks, ", "));
}

/// From where on none, or nearly none, of a sweep's cases can be decided in the collider's scalar.
std::string ill_posed_row(const StressPlan& plan, const StressResult& result, const Sweep& sweep) {
  const auto said = [&sweep](const std::vector<StepStatistics>& steps) -> std::string {
    const auto most = std::ranges::find_if(steps, [](const StepStatistics& step) {
      return 2 * step.ill_posed > step.cases - step.unsupported;
    });
    if (most == steps.end()) return {};
    return fmt::format("from {:g}", sweep.values[most - steps.begin()]);
  };
  return row_of_remarks(plan, result, sweep, "most cases are ill posed", said);
}

/// How much of a sweep a collider does not take part in.
std::string unsupported_row(const StressPlan& plan, const StressResult& result,
                            const Sweep& sweep) {
  const auto said = [](const std::vector<StepStatistics>& steps) -> std::string {
    std::uint64_t cases = 0;
    std::uint64_t unsupported = 0;
    for (const StepStatistics& step : steps) {
      cases += step.cases;
      unsupported += step.unsupported;
    }
    if (unsupported == 0) return {};
    return fmt::format("{:.3g}%",
                       100 * static_cast<double>(unsupported) / static_cast<double>(cases));
  };
  return row_of_remarks(plan, result, sweep, "cases unsupported", said);
}

std::string walk_rows(const StressPlan& plan, const StressResult& result, const Walk& walk) {
  std::string rows;
  for (const std::size_t i : reported_subjects(plan, true)) {
    const StepStatistics* const tally = result.walk(walk, i);
    if (tally == nullptr) continue;
    const auto changes = [](const Changes& c) {
      return fmt::format("{} + {}", c.with_margin, c.within_bound);
    };
    rows += fmt::format(
        "{:<9} {:<19} {:>9} {:>9} {:>7} {:>7} {:>7} {:>15} {:>15} {:>15}\n", walk.name,
        plan.subjects[i].name, tally->well_posed(), tally->walk.touching, tally->missed,
        tally->phantom, tally->wrong_count + tally->gross + tally->lost,
        changes(tally->walk.flickers), changes(tally->walk.jumps), changes(tally->walk.features));
  }
  return rows;
}

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

std::string stress_table(const StressPlan& plan, const StressResult& result) {
  std::string text = result.interrupted ? "interrupted: what was measured until then\n" : "";
  if (!plan.sweeps.empty()) {
    text += fmt::format("breaking points, {} cases a step\n{:<10}", plan.cases, "sweep");
    for (const std::size_t i : reported_subjects(plan, false)) {
      text += fmt::format(" {:>13}", plan.subjects[i].name);
    }
    text += "  unit\n";
    for (const Sweep* const sweep : plan.sweeps) {
      text += row_of_breaking_points(plan, result, *sweep);
    }
    for (const Sweep* const sweep : plan.sweeps) {
      text += ill_posed_row(plan, result, *sweep);
      text += unsupported_row(plan, result, *sweep);
    }
  }
  if (!plan.walks.empty()) {
    text += fmt::format(
        "\nrandom walks; changes that the truth does not ask for: with margin + within bound\n"
        "{:<9} {:<19} {:>9} {:>9} {:>7} {:>7} {:>7} {:>15} {:>15} {:>15}\n",
        "walk", "collider", "frames", "touching", "missed", "phantom", "wrong", "flickers", "jumps",
        "features");
    for (const Walk* const walk : plan.walks) text += walk_rows(plan, result, *walk);
  }
  return text;
}

std::string progress_line(const StressProgress& progress) {
  const auto done = static_cast<double>(progress.done);
  const double share = done / static_cast<double>(progress.total);
  const double left = share > 0 ? progress.seconds / share - progress.seconds : 0;
  return fmt::format("{} of {} cases, {:.0f} a second, {:.0f} s left", progress.done,
                     progress.total, done / progress.seconds, left);
}

std::string complaints(const Comparison& comparison) {
  std::string text;
  if (!comparison.worse.empty()) {
    text += fmt::format("\nworse than stored:\n{}\n", fmt::join(comparison.worse, "\n"));
  }
  if (!comparison.not_compared.empty()) {
    text += fmt::format("\ninterrupted, and not compared:\n{}\n",
                        fmt::join(comparison.not_compared, "\n"));
  }
  return text;
}

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
