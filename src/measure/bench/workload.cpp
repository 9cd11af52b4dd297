#include "measure/bench/workload.hpp"

#include <cmath>

#include "oracle/exact/truth.hpp"

namespace manifuzz {
namespace {

/// Cases drawn for each that is wanted, before the regime is given up.
constexpr std::size_t kDrawsMax = 400;

/// Pairs a workload: what each takes in all fits the first cache, the second, or neither.
constexpr std::size_t kPairsInL1 = 64;
constexpr std::size_t kPairsInL2 = 1024;
constexpr std::size_t kPairsInMemory = 65'536;

bool fits(const PairCase& pair, const std::optional<int>& vertices) {
  return !vertices || (pair.a.polygon.count == *vertices && pair.b.polygon.count == *vertices);
}

}  // namespace

WorkloadSpec usual_workload() {
  return {find_regime("generic"), {}, 0.5, kPairsInL2};
}

std::vector<WorkloadSpec> all_workloads(std::span<const Regime* const> regimes) {
  const WorkloadSpec usual = usual_workload();
  std::vector<WorkloadSpec> specs{usual};
  const auto add = [&](auto WorkloadSpec::*figure, const auto& value) {
    specs.push_back(usual);
    specs.back().*figure = value;
  };
  for (const int vertices : {3, 4, 6, 8}) add(&WorkloadSpec::vertices, vertices);
  for (const double touching : {0.0, 0.1, 1.0}) add(&WorkloadSpec::touching, touching);
  for (const std::size_t pairs : {kPairsInL1, kPairsInMemory}) add(&WorkloadSpec::pairs, pairs);
  for (const Regime* const regime : regimes) {
    if (regime != usual.regime) add(&WorkloadSpec::regime, regime);
  }
  return specs;
}

std::optional<Workload> draw_workload(const WorkloadSpec& spec, std::uint64_t seed) {
  GenerationContext context;
  context.radius = 0.0F;
  Workload workload{spec, {}};
  const double pairs = static_cast<double>(spec.pairs);
  std::size_t touching_left = static_cast<std::size_t>(std::llround(pairs * spec.touching));
  std::size_t apart_left = spec.pairs - touching_left;
  for (std::uint64_t i = 0; touching_left + apart_left > 0; ++i) {
    if (i >= kDrawsMax * spec.pairs) return std::nullopt;
    PairCase pair = generate(seed, *spec.regime, i, context);
    if (!fits(pair, spec.vertices)) continue;
    std::size_t& left = exact::Truth(pair).separation() <= 0 ? touching_left : apart_left;
    if (left == 0) continue;
    --left;
    workload.pairs.push_back(std::move(pair));
  }
  return workload;
}

}  // namespace manifuzz
