#include "report/scene_report.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "kernel/target.hpp"
#include "measure/provenance.hpp"

namespace manifuzz {
namespace {

using Points = std::vector<std::pair<double, double>>;

/// Bodies and ns a step, by scene, in the order of the runs.
std::vector<std::pair<std::string, Points>> times_by_scene(const std::vector<SceneRun>& runs) {
  std::vector<std::pair<std::string, Points>> times;
  for (const SceneRun& run : runs) {
    if (times.empty() || times.back().first != run.scene) times.push_back({run.scene, {}});
    times.back().second.emplace_back(static_cast<double>(run.bodies), run.ns_per_step);
  }
  return times;
}

/// The error that counts: a solver takes depths and positions alike.
double error_of(const StepTally& judged) {
  return std::max(judged.of_size.depth.p999, judged.of_size.position.p999);
}

nlohmann::ordered_json curve_json(const RecyclingCurve& curve) {
  nlohmann::ordered_json json{{"scene", curve.scene}, {"bodies", curve.bodies}};
  json["points"] = nlohmann::ordered_json::array();
  for (const RecyclingRun& run : curve.runs) {
    const auto figures = [](const Spread& spread) {
      return nlohmann::ordered_json{
          {"median", spread.median}, {"p999", spread.p999}, {"max", spread.max}};
    };
    json["points"].push_back({{"motion", run.motion},
                              {"skipped", run.skipped},
                              {"judged", run.judged.cases},
                              {"wrong", run.judged.wrong()},
                              {"depth", figures(run.judged.of_size.depth)},
                              {"position", figures(run.judged.of_size.position)},
                              {"normal", figures(run.judged.of_size.normal)}});
  }
  return json;
}

}  // namespace

LinePlot scaling_plot(const std::vector<SceneRun>& runs) {
  LinePlot plot{
      .title = "time of a step against bodies", .x_label = "bodies", .y_label = "ns a step"};
  for (const auto& [scene, points] : times_by_scene(runs)) {
    const auto exponent = fitted_exponent(points);
    const std::string suffix = exponent ? fmt::format(", exponent {:.2f}", *exponent) : "";
    plot.lines.push_back({.name = scene + suffix, .points = points, .breaks_at = {}});
  }
  return plot;
}

LinePlot recycling_plot(const std::vector<RecyclingCurve>& curves) {
  LinePlot plot{.title = "what recycling costs",
                .x_label = "pairs skipped, % of those that strict mode would collide",
                .y_label = "error of depth or position, 99.9%, share of the size",
                .is_linear_in_x = true};
  for (const RecyclingCurve& curve : curves) {
    Points points;
    for (const RecyclingRun& run : curve.runs) {
      points.emplace_back(100 * run.skipped, error_of(run.judged));
    }
    plot.lines.push_back({curve.scene, points, {}});
  }
  return plot;
}

std::vector<SkipBar> skip_bars(const std::vector<SceneRun>& runs) {
  std::vector<SkipBar> bars;
  for (const SceneRun& run : runs) {
    if (bars.empty() || bars.back().name != run.scene) bars.emplace_back();
    const scene::PairCounts& pairs = run.counts.pairs;
    const auto all = static_cast<double>(std::max<std::size_t>(1, pairs.candidates));
    const auto percent = [&](std::size_t part) { return 100 * static_cast<double>(part) / all; };
    bars.back() = {run.scene, percent(pairs.at_rest), percent(pairs.separated),
                   percent(pairs.recycled), percent(pairs.collided)};
  }
  return bars;
}

std::string curves_table(const std::vector<RecyclingCurve>& curves) {
  std::string text = fmt::format("{:<14} {:>7} {:>8} {:>10} {:>13} {:>13} {:>15} {:>8}\n", "scene",
                                 "bodies", "motion", "% skipped", "depth, median", "depth, 99.9%",
                                 "position, 99.9%", "% wrong");
  for (const RecyclingCurve& curve : curves) {
    for (const RecyclingRun& run : curve.runs) {
      const auto cases = static_cast<double>(std::max<std::uint64_t>(1, run.judged.cases));
      text += fmt::format("{:<14} {:>7} {:>8} {:>10.1f} {:>13.2e} {:>13.2e} {:>15.2e} {:>8.2f}\n",
                          curve.scene, curve.bodies, run.motion, 100 * run.skipped,
                          run.judged.of_size.depth.median, run.judged.of_size.depth.p999,
                          run.judged.of_size.position.p999,
                          100 * static_cast<double>(run.judged.wrong()) / cases);
    }
  }
  return text;
}

nlohmann::ordered_json report_json(const SceneReport& report) {
  nlohmann::ordered_json json = provenance(1, {});
  json["machine"]["instruction_set"] = kernel::targets().front();
  json["rows"] = nlohmann::ordered_json::array();
  for (const SceneRun& run : report.runs) json["rows"].push_back(row_json(run));
  json["exponents"] = nlohmann::ordered_json::array();
  for (const auto& [scene, points] : times_by_scene(report.runs)) {
    const auto exponent = fitted_exponent(points);
    if (exponent) json["exponents"].push_back({{"scene", scene}, {"exponent", *exponent}});
  }
  json["recycling"] = nlohmann::ordered_json::array();
  for (const RecyclingCurve& curve : report.curves) json["recycling"].push_back(curve_json(curve));
  return json;
}

}  // namespace manifuzz
