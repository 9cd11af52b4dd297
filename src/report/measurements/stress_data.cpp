#include "engines/provenance.hpp"
#include "report/measurements/measurements.hpp"
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

Json sweeps_json(const StressPlan& plan, const StressResult& result) {
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

Json walks_json(const StressPlan& plan, const StressResult& result) {
  Json rows = Json::array();
  for (const Walk* const walk : plan.walks) {
    for (std::size_t i = 0; i < plan.subjects.size(); ++i) {
      const StepStatistics* const tally = result.walk(*walk, i);
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

}  // namespace manifuzz
