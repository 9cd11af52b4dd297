#include <array>

#include <fmt/format.h>

#include "measure/provenance.hpp"
#include "report/measurements.hpp"
#include "report/words.hpp"

namespace manifuzz {
namespace {

using Json = nlohmann::ordered_json;

void add_worst_index(Json& json, const Spread& spread) {
  json["worst_index"] = spread.worst;
}

Json counts_json(const StepStatistics& step) {
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

Json step_json(const StepStatistics& step) {
  Json json = counts_json(step);
  json.update(spreads_json(step.of_size, add_worst_index));
  json["of_bound"] = spreads_json(step.of_bound, add_worst_index);
  json["roundoffs_of_extent"] = spread_json(step.of_extent);
  add_worst_index(json["roundoffs_of_extent"], step.of_extent);
  return json;
}

/// The worst contact of a sweep: the largest error of depth or position.
Json worst_json(const StressPlan& plan, const Sweep& sweep,
                const std::vector<StepStatistics>& steps) {
  Json json;
  double worst = -1;
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

/// Calls `use(sweep, subject, steps)` for each sweep of each subject that takes part in sweeps.
void for_sweeps(const StressPlan& plan, const StressResult& result, const auto& use) {
  for (const Sweep* const sweep : plan.sweeps) {
    for (std::size_t i = 0; i < plan.subjects.size(); ++i) {
      if (!plan.subjects[i].walks_only) use(*sweep, plan.subjects[i], result.steps(*sweep, i));
    }
  }
}

/// Calls `use(walk, subject, tally)` for each walk that a subject took.
void for_walks(const StressPlan& plan, const StressResult& result, const auto& use) {
  for (const Walk* const walk : plan.walks) {
    for (std::size_t i = 0; i < plan.subjects.size(); ++i) {
      const StepStatistics* const tally = result.walk(*walk, i);
      if (tally != nullptr) use(*walk, plan.subjects[i], *tally);
    }
  }
}

Json sweeps_json(const StressPlan& plan, const StressResult& result) {
  Json rows = Json::array();
  for_sweeps(plan, result,
             [&](const Sweep& sweep, const StressSubject& subject, const auto& steps) {
               const auto breaking = breaking_step(steps);
               Json row{{"sweep", sweep.name},
                        {"collider", subject.name},
                        {"unit", sweep.unit},
                        {"breaking_point", breaking ? Json(sweep.values[*breaking]) : Json()},
                        {"steps", Json::array()},
                        {"worst", worst_json(plan, sweep, steps)}};
               for (std::size_t k = 0; k < steps.size(); ++k) {
                 Json step{{"x", sweep.values[k]}};
                 step.update(step_json(steps[k]));
                 row["steps"].push_back(std::move(step));
               }
               rows.push_back(std::move(row));
             });
  return rows;
}

Json walks_json(const StressPlan& plan, const StressResult& result) {
  Json rows = Json::array();
  for_walks(plan, result, [&](const Walk& walk, const auto& subject, const StepStatistics& tally) {
    Json row{{"walk", walk.name},
             {"collider", subject.name},
             {"touching", tally.walk.touching},
             {"flickers", changes_json(tally.walk.flickers)},
             {"jumps", changes_json(tally.walk.jumps)},
             {"features", changes_json(tally.walk.features)}};
    row.update(counts_json(tally));
    rows.push_back(std::move(row));
  });
  return rows;
}

constexpr std::size_t kSpreadColumns = 21;
constexpr std::size_t kWalkColumns = 7;

std::array<Spread, kSpreadColumns / 3> spreads_of(const StepStatistics& step) {
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
                      const StepStatistics& tally) {
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}", name, subject.name, x, tally.cases,
                     tally.unsupported, tally.ill_posed, tally.contacts, tally.missed,
                     tally.phantom, tally.wrong_count, tally.gross, tally.lost);
}

}  // namespace

Json stress_json(const StressPlan& plan, const StressResult& result, const Comparison& comparison) {
  std::vector<Declaration> declarations;
  for (const StressSubject& subject : plan.subjects) {
    const bool is_collider = subject.name != kIdealName && !subject.walks_only;
    if (is_collider) declarations.push_back(subject.collider.declaration);
  }
  Json json = provenance(plan.seed, declarations);
  json["cases"] = plan.cases;
  json["frames"] = plan.frames;
  json["flush_to_zero"] = plan.flush_to_zero;
  json["seconds"] = result.seconds;
  json["interrupted"] = result.interrupted;
  json["worse"] = comparison.worse;
  json["not_compared"] = comparison.not_compared;
  json["sweeps"] = sweeps_json(plan, result);
  json["walks"] = walks_json(plan, result);
  return json;
}

std::string stress_csv(const StressPlan& plan, const StressResult& result) {
  std::string text = csv_heading();
  for_sweeps(
      plan, result, [&](const Sweep& sweep, const StressSubject& subject, const auto& steps) {
        for (std::size_t k = 0; k < steps.size(); ++k) {
          text += csv_start(sweep.name, subject, fmt::format("{}", sweep.values[k]), steps[k]);
          for (const Spread& spread : spreads_of(steps[k])) text += spread_csv(spread);
          text += std::string(kWalkColumns, ',') + '\n';
        }
      });
  for_walks(plan, result, [&](const Walk& walk, const auto& subject, const StepStatistics& tally) {
    text += csv_start(walk.name, subject, "", tally);
    text += std::string(kSpreadColumns, ',') + fmt::format(",{}", tally.walk.touching);
    for (const Changes& changes : {tally.walk.flickers, tally.walk.jumps, tally.walk.features}) {
      text += fmt::format(",{},{}", changes.with_margin, changes.within_bound);
    }
    text += '\n';
  });
  return text;
}

}  // namespace manifuzz
