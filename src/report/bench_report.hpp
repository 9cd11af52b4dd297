#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "measure/bench/bench.hpp"
#include "report/gnuplot.hpp"

namespace manifuzz {

/// "PROCESSOR, COMPILER" and an empty line, of what `bench_json` gave.
std::string machine_line(const nlohmann::ordered_json& json);

/// All rows for people.
std::string bench_table(const std::vector<BenchRow>& rows);

/// All rows with commas, a heading first.
std::string bench_csv(const std::vector<BenchRow>& rows);

/// Where the rows come from, and "rows": collider, query, input, target, vertices, touching,
/// regime, pairs, ns_per_pair, speedup_over_box2d, error, missed, phantom, cases.
nlohmann::ordered_json bench_json(const std::vector<BenchRow>& rows,
                                  const std::vector<BenchSubject>& subjects, std::uint64_t seed);

/// Run time against error over the first workload, a point for each that gives manifolds.
PointPlot bench_plot(const std::vector<BenchRow>& rows);

}  // namespace manifuzz
