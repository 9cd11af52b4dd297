#include "measure/digest.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/random.hpp"
#include "base/text.hpp"
#include "collider/answer_hash.hpp"
#include "generating/regime.hpp"
#include "judging/by_curve.hpp"
#include "process/signals.hpp"

namespace manifuzz {
namespace {

constexpr std::uint64_t kBatch = 256;

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
