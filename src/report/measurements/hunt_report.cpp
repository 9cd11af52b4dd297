#include "report/measurements/hunt_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "base/text.hpp"
#include "report/outputs.hpp"
#include "report/rows.hpp"

namespace manifuzz {
namespace {

using Json = nlohmann::ordered_json;

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

Json row_json(std::string_view measure, const WorstFound& found) {
  Json row{
      {"measure", measure}, {"worst", found.value}, {"worst_drawn", nullptr}, {"file", found.file}};
  if (found.drawn) row["worst_drawn"] = *found.drawn;
  return row;
}

/// A row for each measure, and one for each bound.
Json rows_json(const Hunt& hunt) {
  Json rows = Json::array();
  const WorstFound* share = nullptr;
  for (const WorstFound& found : hunt.worst) {
    if (measure_of(found.gauge) == Measure::bound_share) {
      if (share == nullptr || found.value > share->value) share = &found;
    } else {
      rows.push_back(row_json(name_of(measure_of(found.gauge), kMeasureNames), found));
    }
  }
  if (share == nullptr) return rows;
  WorstFound of_all = *share;
  for (const WorstFound& found : hunt.worst) {
    if (measure_of(found.gauge) != Measure::bound_share || !found.drawn) continue;
    of_all.drawn = std::max(of_all.drawn.value_or(0), *found.drawn);
  }
  rows.push_back(row_json(name_of(Measure::bound_share, kMeasureNames), of_all));
  for (const WorstFound& found : hunt.worst) {
    if (measure_of(found.gauge) != Measure::bound_share) continue;
    rows.push_back(row_json(name_of(found.gauge, kGaugeNames), found));
  }
  return rows;
}

}  // namespace

std::string hunt_line(const HuntProgress& progress) {
  if (!progress.cases.saving.empty()) return progress.cases.saving;
  const std::uint64_t cases = progress.cases.tally.cases();
  const double seconds = progress.cases.seconds;
  std::string line = fmt::format("{} cases, {:.0f} a second; {} cells", cases,
                                 per_second(cases, seconds), progress.cells);
  if (progress.cells_drawn) line += fmt::format(" ({} by drawing)", *progress.cells_drawn);
  line += fmt::format("; {}, {:.2g} a second", counted(progress.behaviours, "behaviour"),
                      per_second(progress.behaviours, seconds));
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
  text += fmt::format("{:<40}{:>12}{:>12}\n", "cells filled", hunt.cells,
                      is_compared ? fmt::format("{}", *hunt.cells_drawn) : "");
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
  const Json of_campaign = json_of(hunt.campaign.result);
  Json json;
  for (const char* const key : {"machine", "compiler", "seed", "versions", "subject", "oracle",
                                "cases", "seconds", "cases_per_second", "jobs", "interrupted"}) {
    if (of_campaign.contains(key)) json[key] = of_campaign.at(key);
  }
  json["generations"] = hunt.generations;
  json["cells"] = hunt.cells;
  json["cells_drawn"] = hunt.cells_drawn ? Json(*hunt.cells_drawn) : Json();
  json["rows"] = rows_json(hunt);
  for (const char* const key : {"verdicts", "unexplained", "accepted", "stale", "unshrunk"}) {
    if (of_campaign.contains(key)) json[key] = of_campaign.at(key);
  }
  json["buckets"] = of_campaign.at("buckets");
  json["buckets_drawn"] = hunt.buckets_drawn;
  return json;
}

}  // namespace manifuzz
