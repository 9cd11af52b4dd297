#pragma once

#include <functional>
#include <optional>

#include "measure/bench/bench_errors.hpp"
#include "measure/bench/timing.hpp"

namespace manifuzz {

/// One subject over one workload.
struct BenchRow {
  const BenchSubject* subject = nullptr;
  std::size_t workload = 0;  ///< its index
  WorkloadSpec spec;
  Timing timing;
  std::optional<BenchErrors> errors;  ///< none where it gives no manifolds
};

struct BenchOptions {
  std::uint64_t seed = 1;
  std::size_t judged = 20'000;  ///< cases a workload whose errors are measured
  TimingOptions timing;
};

/// Fewer cases and shorter repetitions.
BenchOptions quick_bench();

/// Every subject over every workload that its regime has cases for. `on_workload` is told which
/// one comes next.
std::vector<BenchRow> run_bench(const std::vector<BenchSubject>& subjects,
                                const std::vector<WorkloadSpec>& workloads,
                                const BenchOptions& options,
                                const std::function<void(std::size_t)>& on_workload);

}  // namespace manifuzz
