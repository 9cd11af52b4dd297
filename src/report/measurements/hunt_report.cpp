#include "report/measurements/hunt_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "base/text.hpp"
#include "report/outputs.hpp"
#include "report/rows.hpp"

namespace manifuzz {
namespace {

std::string in_words(Gauge gauge) {
  switch (gauge) {
    case Gauge::error:
      return "error of a wrong answer, of the size";
    case Gauge::missed:
      return "depth that was missed, of the size";
    case Gauge::normal_share:
      return "share of the bound of a normal";
    case Gauge::position_share:
      return "share of the bound of a position";
    case Gauge::depth_share:
      return "share of the bound of a depth";
  }
  return "";
}

std::string row_of(const WorstFound& found) {
  const std::string drawn =
      found.drawn ? *found.drawn > 0 ? fmt::format("{:.3g}", *found.drawn) : "none" : "";
  return fmt::format("{:<40}{:>12}{:>12}\n", in_words(found.gauge),
                     found.value > 0 ? fmt::format("{:.3g}", found.value) : "none", drawn);
}

}  // namespace

std::string hunt_line(const HuntProgress& progress) {
  if (!progress.cases.saving.empty()) return progress.cases.saving;
  const std::uint64_t cases = progress.cases.tally.cases();
  const double seconds = progress.cases.seconds;
  std::string line = fmt::format("{} cases, {:.0f} a second; {} cells", cases,
                                 per_second(cases, seconds), progress.cells);
  if (progress.cells_drawn) line += fmt::format(" ({} by drawing)", *progress.cells_drawn);
  line += fmt::format("; {}, {:.2g} new a second lately", counted(progress.behaviours, "behaviour"),
                      progress.behaviours_a_second);
  if (progress.worst > 0) {
    line +=
        fmt::format("; worst {} {:.3g}", name_of(progress.worst_of, kGaugeNames), progress.worst);
  }
  double left = 0;
  if (progress.plan.seconds) left = *progress.plan.seconds - seconds;
  if (progress.plan.cases && cases > 0) {
    left = seconds * (static_cast<double>(*progress.plan.cases) / static_cast<double>(cases) - 1);
  }
  return line + fmt::format("; {:.0f} s left", std::max(left, 0.0));
}

std::string hunt_rows(const Hunt& hunt) {
  const bool is_compared = hunt.cells_drawn.has_value();
  std::string text =
      fmt::format("{:<40}{:>12}{:>12}\n",
                  fmt::format("worst after {}", counted(hunt.generations, "generation")), "hunted",
                  is_compared ? "drawn" : "");
  text += lines_of(hunt.worst, row_of);
  const auto add_cells = [&](std::string_view what, std::uint64_t FilledCells::*count) {
    text += fmt::format("{:<40}{:>12}{:>12}\n", what, hunt.cells.*count,
                        is_compared ? fmt::format("{}", (*hunt.cells_drawn).*count) : "");
  };
  add_cells("cells filled", &FilledCells::all);
  add_cells("of these, of pairs of conditions", &FilledCells::of_pairs);
  if (!hunt.buckets_drawn.empty()) {
    text += fmt::format("met by drawing alone: {}\n", fmt::join(hunt.buckets_drawn, ", "));
  }
  return text;
}

std::string hunt_screen(const Hunt& hunt, const ShowAgain& show) {
  return hunt_rows(hunt) + "\n" + campaign_screen(hunt.campaign, show);
}

std::string hunt_table(const Hunt& hunt) {
  return hunt_rows(hunt) + "\n" + summary_table(hunt.campaign);
}

nlohmann::ordered_json json_of(const Hunt& hunt) {
  return json_of(result_of(hunt));
}

}  // namespace manifuzz
