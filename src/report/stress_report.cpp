#include "report/stress_report.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "exchange/json.hpp"

namespace manifuzz {
namespace {

using Json = nlohmann::ordered_json;

bool is_ideal(const StressSubject& subject) {
  return subject.name == kIdealName;
}

/// Those that have a row or a column: sweeps are not for the variants, and nobody competes with the
/// ideal.
std::vector<std::size_t> competing(const StressPlan& plan, bool in_walks) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < plan.subjects.size(); ++i) {
    const StressSubject& subject = plan.subjects[i];
    if (!is_ideal(subject) && (in_walks || !subject.walks_only)) numbers.push_back(i);
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

std::string unbroken(const Sweep& sweep, const std::vector<StepTally>& steps) {
  if (steps.size() < sweep.values.size()) return fmt::format("({} steps)", steps.size());
  const auto has_contact = [](const StepTally& step) { return step.contacts > 0; };
  return std::ranges::any_of(steps, has_contact) ? "never" : "-";
}

std::string row_of_breaking_points(const StressPlan& plan, const StressResult& result,
                                   const Sweep& sweep) {
  std::string row = fmt::format("{:<10}", sweep.name);
  for (const std::size_t i : competing(plan, false)) {
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
  for (const std::size_t i : competing(plan, false)) {
    const std::string remark = said(result.steps(sweep, i));
    if (!remark.empty()) remarks.push_back(plan.subjects[i].name + " " + remark);
  }
  if (remarks.empty()) return {};
  return fmt::format("{}: {}: {}\n", sweep.name, what, fmt::join(remarks, ", "));
}

/// From where on none, or nearly none, of a sweep's cases can be decided in the collider's scalar.
std::string ill_posed_row(const StressPlan& plan, const StressResult& result, const Sweep& sweep) {
  const auto said = [&sweep](const std::vector<StepTally>& steps) -> std::string {
    const auto most = std::ranges::find_if(steps, [](const StepTally& step) {
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
  const auto said = [](const std::vector<StepTally>& steps) -> std::string {
    std::uint64_t cases = 0;
    std::uint64_t unsupported = 0;
    for (const StepTally& step : steps) {
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
  for (const std::size_t i : competing(plan, true)) {
    const StepTally* const tally = result.walk(walk, i);
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

constexpr std::size_t kSpreadColumns = 21;
constexpr std::size_t kWalkColumns = 7;

std::array<Spread, kSpreadColumns / 3> spreads_of(const StepTally& step) {
  return {step.of_size.depth,     step.of_size.position, step.of_size.normal, step.of_bound.depth,
          step.of_bound.position, step.of_bound.normal,  step.of_extent};
}

std::string csv_heading() {
  std::string text =
      "sweep,collider,x,cases,unsupported,ill_posed,contacts,missed,phantom,wrong_count,gross,lost";
  for (const char* const figure : {"depth", "position", "normal", "depth_of_bound",
                                   "position_of_bound", "normal_of_bound", "roundoffs_of_extent"}) {
    text += fmt::format(",{0}_median,{0}_p999,{0}_max", figure);
  }
  text += ",touching";
  for (const char* const change : {"flickers", "jumps", "features"}) {
    text += fmt::format(",{0}_with_margin,{0}_within_bound", change);
  }
  return text + '\n';
}

/// What a step of a sweep and a walk, which has no `x`, have in common.
std::string csv_start(std::string_view name, const StressSubject& subject, const std::string& x,
                      const StepTally& tally) {
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}", name, subject.name, x, tally.cases,
                     tally.unsupported, tally.ill_posed, tally.contacts, tally.missed,
                     tally.phantom, tally.wrong_count, tally.gross, tally.lost);
}

}  // namespace

std::string stress_table(const StressPlan& plan, const StressResult& result) {
  std::string text;
  if (!plan.sweeps.empty()) {
    text += fmt::format("breaking points, {} cases a step\n{:<10}", plan.cases, "sweep");
    for (const std::size_t i : competing(plan, false)) {
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

Json stress_sweeps_json(const StressPlan& plan, const StressResult& result) {
  Json rows = Json::array();
  for (const Sweep* const sweep : plan.sweeps) {
    for (std::size_t i = 0; i < plan.subjects.size(); ++i) {
      if (plan.subjects[i].walks_only) continue;
      const auto steps = result.steps(*sweep, i);
      const auto breaking = breaking_step(steps);
      Json row{{"sweep", sweep->name},
               {"collider", plan.subjects[i].name},
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
    for (std::size_t i = 0; i < plan.subjects.size(); ++i) {
      const StepTally* const tally = result.walk(*walk, i);
      if (tally == nullptr) continue;
      Json row{{"walk", walk->name},
               {"collider", plan.subjects[i].name},
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
  std::string text = csv_heading();
  for (const Sweep* const sweep : plan.sweeps) {
    for (std::size_t i = 0; i < plan.subjects.size(); ++i) {
      if (plan.subjects[i].walks_only) continue;
      const auto steps = result.steps(*sweep, i);
      for (std::size_t k = 0; k < steps.size(); ++k) {
        text +=
            csv_start(sweep->name, plan.subjects[i], fmt::format("{}", sweep->values[k]), steps[k]);
        for (const Spread& spread : spreads_of(steps[k])) {
          text += fmt::format(",{},{},{}", spread.median, spread.p999, spread.max);
        }
        text += std::string(kWalkColumns, ',') + '\n';
      }
    }
  }
  for (const Walk* const walk : plan.walks) {
    for (std::size_t i = 0; i < plan.subjects.size(); ++i) {
      const StepTally* const tally = result.walk(*walk, i);
      if (tally == nullptr) continue;
      text += csv_start(walk->name, plan.subjects[i], "", *tally);
      text += std::string(kSpreadColumns, ',') + fmt::format(",{}", tally->walk.touching);
      for (const Changes& changes :
           {tally->walk.flickers, tally->walk.jumps, tally->walk.features}) {
        text += fmt::format(",{},{}", changes.with_margin, changes.within_bound);
      }
      text += '\n';
    }
  }
  return text;
}

}  // namespace manifuzz
