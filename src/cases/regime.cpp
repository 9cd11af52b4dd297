#include "cases/regime.hpp"

#include <algorithm>

#include "cases/regime_list.hpp"

namespace manifuzz {
namespace {

constexpr Regime kRegimes[] = {
#define MANIFUZZ_ENTRY(name, description) {#name, description, draw::name},
    MANIFUZZ_REGIMES(MANIFUZZ_ENTRY)
#undef MANIFUZZ_ENTRY
};

/// Two overlapping right triangles: what is left when every attempt failed.
PairCase plain_pair() {
  const Vector2<float> vertices[] = {{0, 0}, {1, 0}, {0, 1}};
  Body body;
  body.polygon = make_polygon<float>(vertices);
  PairCase pair{body, body};
  pair.b.pose.position = {0.5f, 0.25f};
  return pair;
}

}  // namespace

std::span<const Regime> regimes() {
  return kRegimes;
}

const Regime* find_regime(std::string_view name) {
  const auto* const found = std::find_if(std::begin(kRegimes), std::end(kRegimes),
                                         [&](const Regime& regime) { return regime.name == name; });
  return found == std::end(kRegimes) ? nullptr : found;
}

PairCase generate(std::uint64_t seed, const Regime& regime, std::uint64_t index,
                  const GenerationContext& context) {
  constexpr int attempts = 32;
  Random random(seed, regime.name, index);
  std::optional<PairCase> pair;
  for (int i = 0; i < attempts && !pair; ++i) pair = regime.attempt(random, context);
  if (!pair) pair = plain_pair();
  if (context.radius) pair->a.polygon.radius = pair->b.polygon.radius = *context.radius;
  return *pair;
}

}  // namespace manifuzz
