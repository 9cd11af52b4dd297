#include "cli/stress_report.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "cases/json.hpp"

namespace manifuzz {
namespace {

using Json = nlohmann::ordered_json;

bool is_ideal(const Contestant& contestant) {
  return contestant.name == kIdealName;
}

/// Those that have a row or a column: sweeps are not for the variants, and nobody competes with the
/// ideal.
std::vector<std::size_t> competing(const StressPlan& plan, bool in_walks) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < plan.contestants.size(); ++i) {
    const Contestant& contestant = plan.contestants[i];
    if (!is_ideal(contestant) && (in_walks || !contestant.walks_only)) numbers.push_back(i);
  }
  return numbers;
}

Json spread_json(const Spread& spread) {
  return {{"median", spread.median},
          {"p999", spread.p999},
          {"max", spread.max},
          {"worst_index", spread.worst}};
}

Json figures_json(const FigureSpreads& figures) {
  return {{"depth", spread_json(figures.depth)},
          {"position", spread_json(figures.position)},
          {"normal", spread_json(figures.normal)}};
}

Json counts_json(const StepTally& step) {
  return {{"cases", step.cases},
          {"unsupported", step.unsupported},
          {"ill_posed", step.ill_posed},
          {"contacts", step.contacts},
          {"missed", step.missed},
          {"phantom", step.phantom},
          {"wrong_count", step.wrong_count},
          {"gross", step.gross},
          {"lost", step.lost}};
}

Json step_json(const StepTally& step) {
  Json json = counts_json(step);
  json.update(figures_json(step.of_size));
  json["of_bound"] = figures_json(step.of_bound);
  json["roundoffs_of_extent"] = spread_json(step.of_extent);
  return json;
}

Json case_json(const PairCase& pair) {
  std::string line;
  append_case_line(line, pair);
  return Json::parse(line);
}

/// The worst contact of a sweep: the largest error of depth or position.
Json worst_json(const StressPlan& plan, const Sweep& sweep, const std::vector<StepTally>& steps) {
  Json json;
  float worst = -1;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    for (const auto& [what, spread] : {std::pair("depth", steps[i].of_size.depth),
                                       std::pair("position", steps[i].of_size.position)}) {
      if (steps[i].contacts == 0 || spread.max <= worst) continue;
      worst = spread.max;
      json = {
          {"x", sweep.values[i]}, {"error", what}, {"share", spread.max}, {"index", spread.worst}};
    }
  }
  if (json.is_null()) return json;
  json["case"] = case_json(draw_case(plan.seed, sweep, json["x"], json["index"]));
  return json;
}

Json changes_json(const Changes& changes) {
  return {{"with_margin", changes.with_margin},
          {"within_bound", changes.within_bound},
          {"first_with_margin", changes.with_margin > 0 ? Json(changes.first) : Json()}};
}

std::string row_of_breaking_points(const StressPlan& plan, const StressResult& result,
                                   const Sweep& sweep) {
  std::string row = fmt::format("{:<10}", sweep.name);
  for (const std::size_t i : competing(plan, false)) {
    const auto steps = result.steps(sweep, i);
    const auto step = breaking_step(steps);
    const bool is_whole = steps.size() == sweep.values.size();
    row += fmt::format(" {:>13}", step       ? fmt::format("{:g}", sweep.values[*step])
                                  : is_whole ? "never"
                                             : fmt::format("({} steps)", steps.size()));
  }
  return row + fmt::format("  {}\n", sweep.unit);
}

/// From where on none, or nearly none, of a sweep's cases can be decided in float.
std::string ill_posed_row(const StressPlan& plan, const StressResult& result, const Sweep& sweep) {
  for (const std::size_t i : competing(plan, false)) {
    const auto steps = result.steps(sweep, i);
    const auto most = std::ranges::find_if(steps, [](const StepTally& step) {
      return 2 * step.ill_posed > step.cases - step.unsupported;
    });
    if (most == steps.end()) continue;
    return fmt::format("{}: for {}, most cases are ill posed from {:g} on\n", sweep.name,
                       plan.contestants[i].name, sweep.values[most - steps.begin()]);
  }
  return {};
}

std::string walk_rows(const StressPlan& plan, const StressResult& result, const Walk& walk) {
  std::string rows;
  for (const std::size_t i : competing(plan, true)) {
    const StepTally* const tally = result.walk(walk, i);
    if (tally == nullptr) continue;
    const auto changes = [](const Changes& c) {
      return fmt::format("{} + {}", c.with_margin, c.within_bound);
    };
    rows += fmt::format(
        "{:<9} {:<19} {:>9} {:>9} {:>7} {:>7} {:>7} {:>15} {:>15} {:>15}\n", walk.name,
        plan.contestants[i].name, tally->well_posed(), tally->walk.touching, tally->missed,
        tally->phantom, tally->wrong_count + tally->gross + tally->lost,
        changes(tally->walk.flickers), changes(tally->walk.jumps), changes(tally->walk.features));
  }
  return rows;
}

}  // namespace

std::string stress_table(const StressPlan& plan, const StressResult& result) {
  std::string text;
  if (!plan.sweeps.empty()) {
    text += fmt::format("breaking points, {} cases a step\n{:<10}", plan.cases, "sweep");
    for (const std::size_t i : competing(plan, false)) {
      text += fmt::format(" {:>13}", plan.contestants[i].name);
    }
    text += "  unit\n";
    for (const Sweep* const sweep : plan.sweeps) {
      text += row_of_breaking_points(plan, result, *sweep);
    }
    for (const Sweep* const sweep : plan.sweeps) text += ill_posed_row(plan, result, *sweep);
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

Json stress_sweeps_json(const StressPlan& plan, const StressResult& result) {
  Json rows = Json::array();
  for (const Sweep* const sweep : plan.sweeps) {
    for (std::size_t i = 0; i < plan.contestants.size(); ++i) {
      if (plan.contestants[i].walks_only) continue;
      const auto steps = result.steps(*sweep, i);
      const auto breaking = breaking_step(steps);
      Json row{{"sweep", sweep->name},
               {"collider", plan.contestants[i].name},
               {"unit", sweep->unit},
               {"breaking_point", breaking ? Json(sweep->values[*breaking]) : Json()},
               {"steps", Json::array()},
               {"worst", worst_json(plan, *sweep, steps)}};
      for (std::size_t k = 0; k < steps.size(); ++k) {
        Json step{{"x", sweep->values[k]}};
        step.update(step_json(steps[k]));
        row["steps"].push_back(std::move(step));
      }
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

Json stress_walks_json(const StressPlan& plan, const StressResult& result) {
  Json rows = Json::array();
  for (const Walk* const walk : plan.walks) {
    for (std::size_t i = 0; i < plan.contestants.size(); ++i) {
      const StepTally* const tally = result.walk(*walk, i);
      if (tally == nullptr) continue;
      Json row{{"walk", walk->name},
               {"collider", plan.contestants[i].name},
               {"touching", tally->walk.touching},
               {"flickers", changes_json(tally->walk.flickers)},
               {"jumps", changes_json(tally->walk.jumps)},
               {"features", changes_json(tally->walk.features)}};
      row.update(counts_json(*tally));
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

std::string stress_csv(const StressPlan& plan, const StressResult& result) {
  std::string text =
      "sweep,collider,x,cases,unsupported,ill_posed,contacts,missed,phantom,wrong_count,gross,lost,"
      "depth_median,depth_p999,depth_max,position_median,position_p999,position_max,"
      "normal_median,normal_p999,normal_max\n";
  for (const Sweep* const sweep : plan.sweeps) {
    for (std::size_t i = 0; i < plan.contestants.size(); ++i) {
      if (plan.contestants[i].walks_only) continue;
      const auto steps = result.steps(*sweep, i);
      for (std::size_t k = 0; k < steps.size(); ++k) {
        const StepTally& step = steps[k];
        text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}", sweep->name,
                            plan.contestants[i].name, sweep->values[k], step.cases,
                            step.unsupported, step.ill_posed, step.contacts, step.missed,
                            step.phantom, step.wrong_count, step.gross, step.lost);
        for (const Spread& spread :
             {step.of_size.depth, step.of_size.position, step.of_size.normal}) {
          text += fmt::format(",{},{},{}", spread.median, spread.p999, spread.max);
        }
        text += '\n';
      }
    }
  }
  return text;
}

}  // namespace manifuzz
