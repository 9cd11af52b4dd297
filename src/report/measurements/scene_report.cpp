#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text.hpp"
#include "engines/provenance.hpp"
#include "report/measurements/measurements.hpp"
#include "report/picture/drawing.hpp"

namespace manifuzz {
namespace {

using Json = nlohmann::ordered_json;
using Points = std::vector<std::pair<double, double>>;

double ratio(std::size_t part, std::size_t all) {
  return static_cast<double>(part) / static_cast<double>(std::max<std::size_t>(1, all));
}

double share_of(std::size_t part, std::size_t all) {
  return 100 * ratio(part, all);
}

/// Where candidate pairs went, in percent: at rest, proven separated, recycled, collided.
std::array<double, 4> shares_of(const scene::PairCounts& pairs) {
  return {share_of(pairs.at_rest, pairs.candidates), share_of(pairs.separated, pairs.candidates),
          share_of(pairs.recycled, pairs.candidates), share_of(pairs.collided, pairs.candidates)};
}

/// Bodies and ns a step, by scene, in the order of the runs.
std::vector<std::pair<std::string, Points>> times_by_scene(const std::vector<SceneRun>& runs) {
  std::vector<std::pair<std::string, Points>> times;
  for (const SceneRun& run : runs) {
    if (times.empty() || times.back().first != run.scene) times.push_back({run.scene, {}});
    times.back().second.emplace_back(static_cast<double>(run.bodies), run.ns_per_step);
  }
  return times;
}

/// In the order of the rows.
std::vector<BaselineRun> baselines(const SceneRun& run) {
  std::vector<BaselineRun> all{run.over_all};
  all.insert(all.end(), run.over_worlds.begin(), run.over_worlds.end());
  all.push_back(run.over_afresh);
  return all;
}

/// A row has all of the run: whoever reads any row of it reads no less than from another.
Json row_json(const SceneRun& run, const BaselineRun& baseline) {
  const scene::StepCounts& counts = run.counts;
  Json json{{"scene", run.scene},
            {"bodies", run.bodies},
            {"moving", static_cast<double>(counts.moved) / static_cast<double>(run.steps)},
            {"mode", run.recycled_motion > 0 ? "recycle" : "strict"},
            {"recycled_motion", run.recycled_motion},
            {"certificates", run.certificates},
            {"threads", run.threads},
            {"steps", run.steps},
            {"ns_per_step", run.ns_per_step},
            {"baseline", baseline.name},
            {"baseline_ns_per_step", baseline.ns_per_step},
            {"speedup_over_baseline", baseline.speedup},
            {"baseline_contacts", nullptr},
            {"speedup_over_box2d", run.over_all.speedup},
            {"speedup_over_box2d_moved", run.speedup_over_moved},
            {"speedup_over_afresh", run.over_afresh.speedup},
            {"speedup_over_one_thread", run.speedup_over_alone},
            {"warm_speedup_over_one_thread", run.warm_speedup_over_alone},
            {"afresh_ns_per_step", run.over_afresh.ns_per_step},
            {"afresh_speedup_over_box2d", run.afresh_over_all},
            {"mismatches", nullptr},
            {"steps_held_against_afresh", run.afresh.steps},
            {"candidates", counts.pairs.candidates},
            {"skipped",
             {{"at_rest", counts.pairs.at_rest},
              {"separated", counts.pairs.separated},
              {"recycled", counts.pairs.recycled}}},
            {"computed", counts.pairs.collided},
            {"left_boxes", counts.left_boxes},
            {"proofs", counts.proofs},
            {"contacts", run.contacts},
            {"pairs", run.pairs},
            {"bytes", run.memory.bodies + run.memory.pairs},
            {"bytes_of_bodies", run.memory.bodies},
            {"bytes_of_pairs", run.memory.pairs}};
  if (run.afresh.steps > 0) json["mismatches"] = run.afresh.mismatches;
  if (baseline.contacts) json["baseline_contacts"] = *baseline.contacts;
  return json;
}

Json curve_json(const RecyclingCurve& curve) {
  Json json{{"scene", curve.scene}, {"bodies", curve.bodies}};
  json["points"] = Json::array();
  for (const RecyclingRun& run : curve.runs) {
    Json point{{"motion", run.motion},
               {"skipped", run.skipped},
               {"judged", run.errors.cases},
               {"wrong", run.errors.wrong()}};
    point.update(spreads_json(run.errors.of_size));
    json["points"].push_back(std::move(point));
  }
  return json;
}

std::string curves_table(const std::vector<RecyclingCurve>& curves) {
  std::string text = fmt::format("{:<14} {:>7} {:>8} {:>10} {:>13} {:>13} {:>15} {:>8}\n", "scene",
                                 "bodies", "motion", "% skipped", "depth, median", "depth, 99.9%",
                                 "position, 99.9%", "% wrong");
  for (const RecyclingCurve& curve : curves) {
    for (const RecyclingRun& run : curve.runs) {
      text += fmt::format("{:<14} {:>7} {:>8} {:>10.1f} {:>13.2e} {:>13.2e} {:>15.2e} {:>8.2f}\n",
                          curve.scene, curve.bodies, run.motion, 100 * run.skipped,
                          run.errors.of_size.depth.median, run.errors.of_size.depth.p999,
                          run.errors.of_size.position.p999,
                          share_of(run.errors.wrong(), run.errors.cases));
    }
  }
  return text;
}

/// Empty where no engine that has a world is installed.
std::string worlds_table(const std::vector<SceneRun>& runs) {
  std::string text;
  for (const SceneRun& run : runs) {
    for (const BaselineRun& world : run.over_worlds) {
      text += fmt::format("{:<14} {:>7} {:<18} {:>10.2f} {:>8.2f} {:>9} {:>9}\n", run.scene,
                          run.bodies, world.name, world.ns_per_step / 1000, world.speedup,
                          *world.contacts, run.contacts);
    }
  }
  if (text.empty()) return text;
  return fmt::format("\n{:<14} {:>7} {:<18} {:>10} {:>8} {:>9} {:>9}\n", "scene", "bodies", "world",
                     "us a step", "x world", "contacts", "ours") +
         text;
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
      // A solver takes depths and positions alike.
      const ErrorSpreads& errors = run.errors.of_size;
      points.emplace_back(100 * run.skipped, std::max(errors.depth.p999, errors.position.p999));
    }
    plot.lines.push_back({curve.scene, points, {}});
  }
  return plot;
}

void write_skipped_plot(const std::string& path, const std::vector<SceneRun>& runs) {
  std::string rows;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const bool is_last = i + 1 == runs.size() || runs[i + 1].scene != runs[i].scene;
    if (!is_last) continue;
    rows +=
        fmt::format("\"{}\" {}\n", runs[i].scene, fmt::join(shares_of(runs[i].counts.pairs), " "));
  }
  draw_plot(path,
            "set title \"Where candidate pairs went\"\nset ylabel \"% of candidate pairs\"\n"
            "set yrange [0:100]\nset style data histograms\nset style histogram rowstacked\n"
            "set style fill solid 0.9\nset boxwidth 0.7\nset xtics rotate by -30 noenhanced\n"
            "set key outside right\nset grid y\n$bars << END\n" +
                rows +
                "END\nplot $bars using 2:xtic(1) title \"at rest\" linecolor '#d0d0d0', "
                "$bars using 3 title \"proven separated\" linecolor '#8fb3d9', "
                "$bars using 4 title \"recycled\" linecolor '#e69f00', "
                "$bars using 5 title \"collided\" linecolor '#1f4e79'\n");
}

std::string scene_table(const SceneResult& result) {
  std::string text = fmt::format(
      "{:<14} {:>7} {:>10} {:>7} {:>8} {:>9} {:>10} {:>9} {:>7} {:>7} {:>10} {:>10} {:>9} {:>7} "
      "{:>7} {:>10}\n",
      "scene", "bodies", "us a step", "x all", "x moved", "x afresh", "us afresh", "pairs",
      "% rest", "% apart", "% recycled", "% collided", "contacts", "B/body", "B/pair",
      "mismatches");
  for (const SceneRun& run : result.runs) {
    const auto [at_rest, separated, recycled, collided] = shares_of(run.counts.pairs);
    text += fmt::format(
        "{:<14} {:>7} {:>10.2f} {:>7.2f} {:>8.2f} {:>9.2f} {:>10.2f} {:>9} {:>7.1f} {:>7.1f} "
        "{:>10.1f} {:>10.1f} "
        "{:>9} {:>7.0f} {:>7.0f} {:>10}\n",
        run.scene, run.bodies, run.ns_per_step / 1000, run.over_all.speedup, run.speedup_over_moved,
        run.over_afresh.speedup, run.over_afresh.ns_per_step / 1000, run.pairs, at_rest, separated,
        recycled, collided, run.contacts, ratio(run.memory.bodies, run.bodies),
        ratio(run.memory.pairs, run.pairs),
        run.afresh.steps > 0 ? std::to_string(run.afresh.mismatches) : "-");
  }
  for (const SceneRun& run : result.runs) {
    if (run.threads == 1) continue;
    text += fmt::format(
        "{} of {} bodies: {} threads are {:.2f} times as fast as one where no baseline steps "
        "between, and {:.2f} where the baselines have emptied the caches\n",
        run.scene, run.bodies, run.threads, run.warm_speedup_over_alone, run.speedup_over_alone);
  }
  text += worlds_table(result.runs);
  if (!result.curves.empty()) text += '\n' + curves_table(result.curves);
  return text;
}

std::string mismatches_in_words(const std::vector<SceneRun>& runs) {
  std::string text;
  for (const SceneRun& run : runs) {
    if (run.afresh.mismatches == 0) continue;
    text += fmt::format("{} of {}: {}\n", run.scene, counted(run.bodies, "body", "bodies"),
                        counted(run.afresh.mismatches, "mismatch", "mismatches"));
  }
  return text;
}

Json scene_json(const SceneResult& result) {
  Json json = provenance(1, {});
  json["rows"] = Json::array();
  for (const SceneRun& run : result.runs) {
    for (const BaselineRun& baseline : baselines(run)) {
      json["rows"].push_back(row_json(run, baseline));
    }
  }
  json["exponents"] = Json::array();
  for (const auto& [scene, points] : times_by_scene(result.runs)) {
    const auto exponent = fitted_exponent(points);
    if (exponent) json["exponents"].push_back({{"scene", scene}, {"exponent", *exponent}});
  }
  json["recycling"] = Json::array();
  for (const RecyclingCurve& curve : result.curves) json["recycling"].push_back(curve_json(curve));
  return json;
}

}  // namespace manifuzz
