#include <algorithm>

#include <fmt/format.h>

#include "measure/provenance.hpp"
#include "report/measurements.hpp"
#include "report/words.hpp"

namespace manifuzz {
namespace {

using Json = nlohmann::ordered_json;

std::string vertices_of(const WorkloadSpec& spec) {
  return spec.vertices ? std::to_string(*spec.vertices) : "mixed";
}

Json row_json(const BenchRow& row) {
  Json json{{"collider", row.subject->name},
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
  const BenchErrors& errors = *row.errors;
  json["error"] = spreads_json(errors.of_extent, [&](Json& spread_json, const Spread& spread) {
    const auto worst = errors.worst.find(spread.worst);
    if (worst != errors.worst.end()) spread_json["worst_case"] = case_json(worst->second);
  });
  json["missed"] = errors.missed;
  json["phantom"] = errors.phantom;
  json["cases"] = errors.cases;
  return json;
}

}  // namespace

std::string machine_line(const Json& json) {
  return fmt::format("{}, {}\n\n", json["machine"]["processor"].get<std::string>(),
                     json["compiler"].get<std::string>());
}

std::string bench_table(const std::vector<BenchRow>& rows) {
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
      const ErrorSpreads& errors = row.errors->of_extent;
      text += fmt::format(" {:>10.3g} {:>10.3g} {:>10.3g} {:>7}", errors.depth.median,
                          errors.depth.p999, errors.position.median, row.errors->missed);
    }
    text += '\n';
  }
  return text;
}

std::string bench_csv(const std::vector<BenchRow>& rows) {
  std::string text =
      "collider,query,input,target,regime,vertices,touching,pairs,ns_per_pair,speedup_over_box2d,"
      "depth_median,depth_p999,depth_max,position_median,position_p999,position_max,"
      "normal_median,normal_p999,normal_max,missed,phantom,cases\n";
  for (const BenchRow& row : rows) {
    text += fmt::format("{},{},{},{},{},{},{},{},{},{}", row.subject->name, row.subject->query,
                        row.subject->input, row.subject->target, row.spec.regime->name,
                        vertices_of(row.spec), row.spec.touching, row.spec.pairs,
                        row.timing.ns_per_pair, row.timing.speedup_over_box2d);
    if (!row.errors) {
      text += std::string(12, ',') + '\n';
      continue;
    }
    const ErrorSpreads& errors = row.errors->of_extent;
    for (const Spread* spread : {&errors.depth, &errors.position, &errors.normal}) {
      text += spread_csv(*spread);
    }
    text += fmt::format(",{},{},{}\n", row.errors->missed, row.errors->phantom, row.errors->cases);
  }
  return text;
}

Json bench_json(const std::vector<BenchRow>& rows, const std::vector<BenchSubject>& subjects,
                std::uint64_t seed) {
  std::vector<Declaration> declarations;
  for (const BenchSubject& subject : subjects) {
    if (subject.collider) declarations.push_back(subject.collider().declaration);
  }
  Json json = provenance(seed, declarations);
  json["rows"] = Json::array();
  for (const BenchRow& row : rows) json["rows"].push_back(row_json(row));
  return json;
}

PointPlot bench_plot(const std::vector<BenchRow>& rows) {
  PointPlot plot{.title = "Run time against error: mixed polygons, half of the pairs touching",
                 .x_label = "ns a pair",
                 .y_label = "depth error, 99.9%, in 2^-24 of the extent",
                 .points = {}};
  // The kernels' subjects come with the widest instruction set first.
  const auto of_kernel =
      std::ranges::find_if(rows, [](const BenchRow& row) { return !row.subject->target.empty(); });
  const std::string widest = of_kernel == rows.end() ? "" : of_kernel->subject->target;
  for (const BenchRow& row : rows) {
    const BenchSubject& subject = *row.subject;
    const bool is_widest = subject.target.empty() || subject.target == widest;
    const bool is_hinted = subject.name.ends_with("+hint");
    if (row.workload > 0 || !row.errors || !is_widest || is_hinted) continue;
    const std::string how = subject.input == "pair" ? "" : ", " + subject.input;
    plot.points.push_back(
        {subject.name + how, row.timing.ns_per_pair, row.errors->of_extent.depth.p999});
  }
  return plot;
}

}  // namespace manifuzz
