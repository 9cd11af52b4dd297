#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "generating/regime.hpp"

namespace manifuzz {

/// Which cases are timed together.
struct WorkloadSpec {
  const Regime* regime = nullptr;
  std::optional<int> vertices;  ///< of both polygons; mixed where there is none
  double touching = 0.5;        ///< the share of pairs that touch
  std::size_t pairs = 1024;     ///< as many as are gone through before the first comes again
};

struct Workload {
  WorkloadSpec spec;
  std::vector<PairCase> pairs;
};

/// The regime `generic`, mixed counts, half touching, in the second cache.
WorkloadSpec usual_workload();

/// The usual workload first; then, each by itself, other counts, shares of touching pairs and
/// numbers of pairs, and other regimes.
std::vector<WorkloadSpec> all_workloads(std::span<const Regime* const> regimes);

/// The regime's first cases that fit, polygons without radius, touching and separated ones mixed.
/// None where the regime has hardly any that fit.
std::optional<Workload> draw_workload(const WorkloadSpec& spec, std::uint64_t seed);

}  // namespace manifuzz
