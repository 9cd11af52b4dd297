#include "measure/bench/bench.hpp"

#include <map>

#include <fmt/format.h>

#include "exchange/json.hpp"

namespace manifuzz {
namespace {

nlohmann::ordered_json spread_json(const ErrorSpread& spread) {
  nlohmann::ordered_json json{
      {"median", spread.median}, {"p999", spread.p999}, {"max", spread.max}};
  if (spread.worst) {
    std::string line;
    append_case_line(line, *spread.worst);
    json["worst_case"] = nlohmann::ordered_json::parse(line);
  }
  return json;
}

std::string vertices_of(const WorkloadSpec& spec) {
  return spec.vertices ? std::to_string(*spec.vertices) : "mixed";
}

}  // namespace

std::vector<BenchRow> run_bench(const std::vector<BenchSubject>& subjects,
                                const std::vector<WorkloadSpec>& workloads,
                                const BenchOptions& options,
                                const std::function<void(std::size_t)>& on_workload) {
  std::vector<BenchRow> rows;
  for (std::size_t w = 0; w < workloads.size(); ++w) {
    on_workload(w);
    const std::optional<Workload> timed = draw_workload(workloads[w], options.seed);
    WorkloadSpec judged_spec = workloads[w];
    judged_spec.pairs = options.judged;
    const std::optional<Workload> judged = draw_workload(judged_spec, options.seed);
    if (!timed || !judged) continue;
    const std::vector<Timing> timings = time_subjects(subjects, *timed, options.timing);
    std::map<std::string, JudgedErrors> errors;  // however it is asked, a collider answers alike
    for (std::size_t i = 0; i < subjects.size(); ++i) {
      BenchRow row{&subjects[i], w, workloads[w], timings[i], {}};
      if (subjects[i].collider) {
        const auto [found, is_new] = errors.try_emplace(subjects[i].name);
        if (is_new) found->second = judged_errors(subjects[i].collider(), judged->pairs);
        row.errors = found->second;
      }
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

nlohmann::ordered_json row_json(const BenchRow& row) {
  nlohmann::ordered_json json{{"collider", row.subject->name},
                              {"query", row.subject->query},
                              {"input", row.subject->input},
                              {"target", row.subject->target}};
  json["vertices"] = vertices_of(row.spec);
  if (row.spec.vertices) json["vertices"] = *row.spec.vertices;
  json["touching"] = row.spec.touching;
  json["regime"] = row.spec.regime->name;
  json["pairs"] = row.spec.pairs;
  json["ns_per_pair"] = row.timing.ns_per_pair;
  json["pairs_per_second"] = 1e9 / row.timing.ns_per_pair;
  json["speedup_over_box2d"] = row.timing.speedup_over_box2d;
  if (!row.errors) return json;
  json["error"] = {{"depth", spread_json(row.errors->depth)},
                   {"position", spread_json(row.errors->position)},
                   {"normal", spread_json(row.errors->normal)}};
  json["missed"] = row.errors->missed;
  json["phantom"] = row.errors->phantom;
  json["cases"] = row.errors->cases;
  return json;
}

std::string rows_csv(const std::vector<BenchRow>& rows) {
  std::string text =
      "collider,query,input,target,regime,vertices,touching,pairs,ns_per_pair,speedup_over_box2d,"
      "depth_median,depth_p999,depth_max,position_median,position_p999,position_max,"
      "normal_median,normal_p999,normal_max,missed,phantom,cases\n";
  for (const BenchRow& row : rows) {
    text += fmt::format("{},{},{},{},{},{},{},{},{},{}", row.subject->name, row.subject->query,
                        row.subject->input, row.subject->target, row.spec.regime->name,
                        vertices_of(row.spec), row.spec.touching, row.spec.pairs,
                        row.timing.ns_per_pair, row.timing.speedup_over_box2d);
    if (row.errors) {
      const JudgedErrors& errors = *row.errors;
      for (const ErrorSpread* spread : {&errors.depth, &errors.position, &errors.normal}) {
        text += fmt::format(",{},{},{}", spread->median, spread->p999, spread->max);
      }
      text += fmt::format(",{},{},{}\n", errors.missed, errors.phantom, errors.cases);
    } else {
      text += std::string(12, ',') + '\n';
    }
  }
  return text;
}

std::string rows_table(const std::vector<BenchRow>& rows) {
  std::string text = fmt::format(
      "{:<9} {:<10} {:<8} {:<10} {:<13} {:>8} {:>8} {:>6} {:>9} {:>8} {:>10} {:>10} {:>10} {:>7}\n",
      "collider", "query", "input", "target", "regime", "vertices", "touching", "pairs", "ns",
      "x box2d", "depth", "99.9%", "position", "missed");
  for (const BenchRow& row : rows) {
    text +=
        fmt::format("{:<9} {:<10} {:<8} {:<10} {:<13} {:>8} {:>8} {:>6} {:>9.1f} {:>8.2f}",
                    row.subject->name, row.subject->query, row.subject->input, row.subject->target,
                    row.spec.regime->name, vertices_of(row.spec), row.spec.touching, row.spec.pairs,
                    row.timing.ns_per_pair, row.timing.speedup_over_box2d);
    if (row.errors) {
      text += fmt::format(" {:>10.3g} {:>10.3g} {:>10.3g} {:>7}", row.errors->depth.median,
                          row.errors->depth.p999, row.errors->position.median, row.errors->missed);
    }
    text += '\n';
  }
  return text;
}

}  // namespace manifuzz
