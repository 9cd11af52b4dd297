#include "generating/regime.hpp"

#include <algorithm>

#include "generating/regime_list.hpp"

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

/// With large radii bodies are put so far away that float ends.
bool is_finite(const PairCase& pair) {
  const auto body_is_finite = [](const Body& body) {
    const auto& vertices = body.polygon.vertices;
    return body.pose.position.allFinite() &&
           std::all_of(vertices.begin(), vertices.begin() + body.polygon.count,
                       [](const Vector2<float>& vertex) { return vertex.allFinite(); });
  };
  return body_is_finite(pair.a) && body_is_finite(pair.b);
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
  for (int i = 0; i < attempts && !pair; ++i) {
    pair = regime.attempt(random, context);
    if (pair && !is_finite(*pair)) pair.reset();
  }
  if (!pair) pair = plain_pair();
  if (context.radius) pair->a.polygon.radius = pair->b.polygon.radius = *context.radius;
  return *pair;
}

}  // namespace manifuzz
