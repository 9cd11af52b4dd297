#include <algorithm>

#include <fmt/format.h>

#include "engines/provenance.hpp"
#include "report/measurements/measurements.hpp"
#include "report/words.hpp"

namespace manifuzz {
namespace {

using Json = nlohmann::ordered_json;

Json row_json(const BenchRow& row) {
  Json json{{"collider", row.subject.name},
            {"query", row.subject.query},
            {"input", row.subject.input},
            {"target", row.subject.target},
            {"vertices", row.spec.vertices ? Json(*row.spec.vertices) : Json("mixed")},
            {"touching", row.spec.touching},
            {"regime", row.spec.regime->name},
            {"pairs", row.spec.pairs},
            {"ns_per_pair", row.timing.ns_per_pair},
            {"pairs_per_second", 1e9 / row.timing.ns_per_pair},
            {"speedup_over_box2d", row.timing.speedup_over_box2d}};
  if (row.timing.ns_without_interface) {
    json["ns_without_interface"] = *row.timing.ns_without_interface;
  }
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

/// What a library takes without the interface; nothing where it is no library.
std::string own_time(const Timing& timing) {
  const auto& ns = timing.ns_without_interface;
  return ns ? fmt::format("{:.1f}", *ns) : "";
}

std::string rows_of(const std::vector<PlotPoint>& points) {
  std::string rows;
  for (const PlotPoint& point : points) {
    rows += fmt::format("{} {} \"{}\"\n", point.x, point.y, point.name);
  }
  return rows;
}

}  // namespace

std::string machine_line(const Json& json) {
  return fmt::format("{}, {}\n\n", json["machine"]["processor"].get<std::string>(),
                     json["compiler"].get<std::string>());
}

std::string bench_table(const std::vector<BenchRow>& rows) {
  std::string text = fmt::format(
      "{:<18} {:<10} {:<8} {:<10} {:<13} {:>8} {:>8} {:>6} {:>9} {:>9} {:>8} {:>10} {:>10} "
      "{:>10} {:>7}\n",
      "collider", "query", "input", "target", "regime", "vertices", "touching", "pairs", "ns",
      "own ns", "x box2d", "depth", "99.9%", "position", "missed");
  for (const BenchRow& row : rows) {
    text += fmt::format(
        "{:<18} {:<10} {:<8} {:<10} {:<13} {:>8} {:>8} {:>6} {:>9.1f} {:>9} {:>8.2f}",
        row.subject.name, row.subject.query, row.subject.input, row.subject.target,
        row.spec.regime->name, row.spec.vertices ? std::to_string(*row.spec.vertices) : "mixed",
        row.spec.touching, row.spec.pairs, row.timing.ns_per_pair, own_time(row.timing),
        row.timing.speedup_over_box2d);
    if (row.errors) {
      const ErrorSpreads& errors = row.errors->of_extent;
      text += fmt::format(" {:>10.3g} {:>10.3g} {:>10.3g} {:>7}", errors.depth.median,
                          errors.depth.p999, errors.position.median, row.errors->missed);
    }
    text += '\n';
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

std::vector<PlotPoint> front(std::vector<PlotPoint> points) {
  std::ranges::sort(points, {}, [](const PlotPoint& p) { return std::pair(p.x, p.y); });
  std::vector<PlotPoint> best;
  for (PlotPoint& point : points) {
    if (best.empty() || point.y < best.back().y) best.push_back(std::move(point));
  }
  return best;
}

void write_bench_plot(const std::string& path, const std::vector<BenchRow>& rows) {
  // The kernels' subjects come with the widest instruction set first.
  const auto of_kernel =
      std::ranges::find_if(rows, [](const BenchRow& row) { return !row.subject.target.empty(); });
  const std::string widest = of_kernel == rows.end() ? "" : of_kernel->subject.target;
  std::vector<PlotPoint> points;
  for (const BenchRow& row : rows) {
    const BenchSubject& subject = row.subject;
    const bool is_widest = subject.target.empty() || subject.target == widest;
    const bool is_hinted = subject.name.ends_with("+hint");
    if (row.workload > 0 || !row.errors || !is_widest || is_hinted) continue;
    const std::string how = subject.input == "pair" ? "" : ", " + subject.input;
    points.push_back(
        {subject.name + how, row.timing.ns_per_pair, row.errors->of_extent.depth.p999});
  }
  draw_plot(path,
            fmt::format(
                "set title \"Run time against error: mixed polygons, half of the pairs touching\" "
                "noenhanced\nset xlabel \"ns a pair\" noenhanced\n"
                "set ylabel \"depth error, 99.9%, in 2^-24 of the extent\" noenhanced\n"
                "set logscale xy\nset grid\nset key off\n"
                "set offsets graph 0.1, graph 0.2, graph 0.1, 0\n"
                "$all << END\n{}END\n$front << END\n{}END\n"
                "plot $front using 1:2 with lines linewidth 2 linecolor '#8fb3d9', "
                "$all using 1:2 with points pointtype 7 linecolor '#1f4e79', "
                "$all using 1:2:3 with labels rotate by 30 offset 0.6,0.4 left noenhanced\n",
                rows_of(points), rows_of(front(points))));
}

}  // namespace manifuzz
