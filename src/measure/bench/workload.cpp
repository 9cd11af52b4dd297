#include "measure/bench/workload.hpp"

#include <cmath>

#include "oracle/exact/truth.hpp"

namespace manifuzz {
namespace {

/// Cases drawn for each that is wanted, before the regime is given up.
constexpr std::size_t kDrawsMax = 400;

bool fits(const PairCase& pair, const std::optional<int>& vertices) {
  return !vertices || (pair.a.polygon.count == *vertices && pair.b.polygon.count == *vertices);
}

}  // namespace

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
