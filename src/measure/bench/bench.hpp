#pragma once

#include <functional>

#include <nlohmann/json.hpp>

#include "measure/bench/timing.hpp"
#include "measure/judged_errors.hpp"

namespace manifuzz {

/// One subject over one workload.
struct BenchRow {
  const BenchSubject* subject = nullptr;
  std::size_t workload = 0;  ///< its index
  WorkloadSpec spec;
  Timing timing;
  std::optional<JudgedErrors> errors;  ///< none where it gives no manifolds
};

struct BenchOptions {
  std::uint64_t seed = 1;
  std::size_t judged = 20'000;  ///< cases a workload whose errors are measured
  TimingOptions timing;
};

/// Every subject over every workload that its regime has cases for. `on_workload` is told which
/// one comes next.
std::vector<BenchRow> run_bench(const std::vector<BenchSubject>& subjects,
                                const std::vector<WorkloadSpec>& workloads,
                                const BenchOptions& options,
                                const std::function<void(std::size_t)>& on_workload);

/// A row as the JSON has it: collider, query, input, target, vertices, touching, regime, pairs,
/// ns_per_pair, speedup_over_box2d, error, missed, phantom, cases.
nlohmann::ordered_json row_json(const BenchRow& row);

/// All rows with commas, a heading first.
std::string rows_csv(const std::vector<BenchRow>& rows);

/// All rows for people.
std::string rows_table(const std::vector<BenchRow>& rows);

}  // namespace manifuzz
