#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text.hpp"
#include "report/measurements/measurements.hpp"

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
  if (steps.size() < sweep.values.size()) return fmt::format("({})", counted(steps.size(), "step"));
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

/// Below the table: from where on none, or nearly none, of a sweep's cases can be decided in a
/// collider's scalar, and how much of it a collider does not take part in.
std::string remarks(const StressPlan& plan, const StressResult& result, const Sweep& sweep) {
  std::vector<std::string> ill_posed;
  std::vector<std::string> left_out;
  for (const std::size_t i : reported_subjects(plan, false)) {
    const auto steps = result.steps(sweep, i);
    std::optional<double> ill_posed_from;
    double cases = 0;
    double unsupported = 0;
    for (std::size_t k = 0; k < steps.size(); ++k) {
      const StepStatistics& step = steps[k];
      const bool is_ill_posed = 2 * step.ill_posed > step.cases - step.unsupported;
      if (is_ill_posed && !ill_posed_from) ill_posed_from = sweep.values[k];
      cases += static_cast<double>(step.cases);
      unsupported += static_cast<double>(step.unsupported);
    }
    const std::string& name = plan.subjects[i].name;
    if (ill_posed_from) ill_posed.push_back(fmt::format("{} from {:g}", name, *ill_posed_from));
    if (unsupported > 0) {
      left_out.push_back(fmt::format("{} {:.3g}%", name, 100 * unsupported / cases));
    }
  }
  std::string text;
  for (const auto& [what, which] : {std::pair("most cases are ill posed", ill_posed),
                                    std::pair("cases unsupported", left_out)}) {
    if (which.empty()) continue;
    text += fmt::format("{}: {}: {}\n", sweep.name, what, fmt::join(which, ", "));
  }
  return text;
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
    // Logarithmic axes have no 0: the last step of a sweep by ulps is drawn at half an ulp.
    line.points.emplace_back(sweep.values[i] > 0 ? sweep.values[i] : 0.5,
                             std::max(of_size.depth.p999, of_size.position.p999));
  }
  return line;
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

}  // namespace

std::string stress_table(const StressPlan& plan, const StressResult& result) {
  std::string text = result.interrupted ? "interrupted: what was measured until then\n" : "";
  if (!plan.sweeps.empty()) {
    text += fmt::format("breaking points, {} a step\n{:<10}", counted(plan.cases, "case"), "sweep");
    for (const std::size_t i : reported_subjects(plan, false)) {
      text += fmt::format(" {:>13}", plan.subjects[i].name);
    }
    text += "  unit\n";
    for (const Sweep* const sweep : plan.sweeps) {
      text += row_of_breaking_points(plan, result, *sweep);
    }
    for (const Sweep* const sweep : plan.sweeps) text += remarks(plan, result, *sweep);
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
  return fmt::format("{} of {}, {:.0f} a second, {:.0f} s left", progress.done,
                     counted(progress.total, "case"), done / progress.seconds, left);
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

std::array<std::string, 2> stress_picture_files(const std::filesystem::path& folder,
                                                const Sweep& sweep) {
  const auto file = [&](const char* ending) {
    return (folder / fmt::format("{}.{}", sweep.name, ending)).string();
  };
  return {file("svg"), file("png")};
}

void write_stress_pictures(const std::filesystem::path& folder, const StressPlan& plan,
                           const StressResult& result, const Sweep& sweep) {
  const LinePlot plot = plot_of(plan, result, sweep);
  if (plot.lines.empty()) return;
  for (const std::string& file : stress_picture_files(folder, sweep)) write_plot(file, plot);
}

}  // namespace manifuzz
