#include "measure/digest.hpp"

#include <algorithm>
#include <bit>

#include <fmt/format.h>

#include "base/random.hpp"
#include "base/text.hpp"
#include "generating/regime.hpp"
#include "judging/by_curve.hpp"
#include "process/signals.hpp"

namespace manifuzz {
namespace {

constexpr std::uint64_t kBatch = 256;

/// Words one after the other: each step is one to one, so another word gives another value.
class Hash {
 public:
  void add(std::uint64_t word) { value_ = mix(value_ ^ word); }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add(const Vector2<double>& v) {
    add(v.x());
    add(v.y());
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = hash_of("digest");
};

std::uint64_t word_of(const Feature& feature) {
  return std::uint64_t{feature.index} << 8 | static_cast<std::uint64_t>(feature.kind);
}

void add(Hash& hash, const Manifold<double>& manifold) {
  hash.add(static_cast<std::uint64_t>(manifold.count));
  if (manifold.count == 0) return;
  hash.add(manifold.normal);
  hash.add(static_cast<std::uint64_t>(manifold.reference));
  for (int i = 0; i < manifold.count; ++i) {
    const ContactPoint<double>& point = manifold.points[i];
    hash.add(point.position);
    hash.add(point.depth);
    hash.add(word_of(point.features.a) << 16 | word_of(point.features.b));
  }
}

void add(Hash& hash, const Answer& answer) {
  hash.add(static_cast<std::uint64_t>(answer.index()));
  if (const auto* const penetration = std::get_if<Penetration>(&answer)) {
    hash.add(std::uint64_t{penetration->touches});
    hash.add(penetration->normal.value_or(Vector2<double>(0, 0)));
    hash.add(penetration->depth);
  }
  if (const auto* const manifold = manifold_in(answer)) add(hash, *manifold);
  if (const UsedShapes* const used = used_by(answer)) {
    for (const Side side : {Side::a, Side::b}) {
      hash.add(static_cast<std::uint64_t>((*used)[side].count));
      for (const Vector2<double>& vertex : (*used)[side].corners()) hash.add(vertex);
      if (const auto radius = (*used)[side].round_radius) hash.add(static_cast<double>(*radius));
    }
  }
  if (const auto* const lost = std::get_if<Lost>(&answer)) {
    hash.add(static_cast<std::uint64_t>(lost->how));
  }
}

std::vector<Answer> ask_all(const Collider& collider, const std::vector<PairCase>& pairs,
                            Interruption& interruption) {
  std::vector<Answer> answers(pairs.size());
  if (!collider.is_isolated()) {
    const EndingSignalsLetThrough signals;  // it may never return
    std::ranges::transform(pairs, answers.begin(), collider.collide);
    return answers;
  }
  const std::size_t answered =
      collider.collide_many(pairs, answers, [&] { return !interruption.is_stopped(); });
  if (answered == pairs.size() || interruption.is_stopped()) return answers;
  throw UserError(
      fmt::format("digest: {} gives no answer again and again", collider.declaration.name));
}

}  // namespace

Digest digest(const DigestPlan& plan, Interruption& interruption,
              const std::function<void(std::uint64_t)>& progress) {
  Digest result;
  Hash over_all;
  for (const Regime& regime : regimes()) {
    if (regime.is_round && !takes_round_shapes(plan.collider.declaration)) continue;
    RegimeDigest& of_regime = result.regimes.emplace_back(RegimeDigest{regime.name});
    Hash hash;
    for (std::uint64_t first = 0; first < plan.cases; first += kBatch) {
      progress((result.regimes.size() - 1) * plan.cases + first);
      std::vector<PairCase> pairs;
      for (std::uint64_t i = first; i < std::min(first + kBatch, plan.cases); ++i) {
        pairs.push_back(generate(plan.seed, regime, i));
      }
      for (const Answer& answer : ask_all(plan.collider, pairs, interruption)) {
        add(hash, answer);
        of_regime.contacts += touches(answer) ? 1 : 0;
        of_regime.lost += std::holds_alternative<Lost>(answer) ? 1 : 0;
      }
      if (interruption.is_stopped()) throw UserError("digest: interrupted; nothing is told");
    }
    of_regime.hash = hash.value();
    if (plan.cases > 0 && of_regime.lost == plan.cases) {
      throw UserError(fmt::format("digest: {} gives no answer to {}",
                                  plan.collider.declaration.name, regime.name));
    }
    over_all.add(hash_of(regime.name));
    over_all.add(of_regime.hash);
  }
  result.hash = over_all.value();
  return result;
}

}  // namespace manifuzz
