#include "campaign/plan.hpp"

#include "campaign/in_child.hpp"

namespace manifuzz {

DeclaredAnswer declared_answer(const Collider& collider, const PairCase& pair,
                               Interruption& interruption) {
  return {collider.declaration, ask_in_child(collider, pair, interruption)};
}

JudgedCase judged_case(const CorpusCase& given, const Collider& subject, const Collider& oracle,
                       Interruption& interruption) {
  return {given, declared_answer(subject, given.pair, interruption),
          declared_answer(oracle, given.pair, interruption),
          judge_in_child(given.pair, subject, oracle, interruption)};
}

void BucketTally::add(const BucketTally& tally) {
  if (tally.count == 0) return;
  if (count == 0) {
    *this = tally;
    return;
  }
  count += tally.count;
  first = std::min(first, tally.first);
  if (tally.magnitude > magnitude || (tally.magnitude == magnitude && tally.worst < worst)) {
    magnitude = tally.magnitude;
    worst = tally.worst;
  }
}

void RegimeTally::add(const RegimeTally& tally) {
  cases += tally.cases;
  touching += tally.touching;
  near += tally.near;
  unexplained += tally.unexplained;
  failures += tally.failures;
}

void Tally::add(std::size_t regime, CaseNumber number, const Standing& standing,
                const Judgement& judgement) {
  widen(of_subject, judgement.of_subject);
  widen(of_oracle, judgement.of_oracle);
  const Bucket& bucket = judgement.bucket;
  RegimeTally& of_regime = regimes[regime];
  ++of_regime.cases;
  if (standing.touching) {
    ++of_regime.touching;
  } else if (standing.near) {
    ++of_regime.near;
  }
  if (is_unexplained(bucket.verdict)) ++of_regime.unexplained;
  if (is_failure(bucket)) ++of_regime.failures;
  ++verdicts[static_cast<std::size_t>(bucket.verdict)];
  if (judgement.is_by_tolerance) ++by_tolerance;
  if (bucket.verdict != Verdict::agree) {
    buckets[index_of(bucket)].add({1, number, number, judgement.magnitude});
  }
  if (judgement.explanation != nullptr) ++explained[index_of(*judgement.explanation)][regime];
}

void Tally::add(const Tally& tally) {
  widen(of_subject, tally.of_subject);
  widen(of_oracle, tally.of_oracle);
  for (std::size_t i = 0; i < verdicts.size(); ++i) verdicts[i] += tally.verdicts[i];
  by_tolerance += tally.by_tolerance;
  for (std::size_t i = 0; i < regimes.size(); ++i) regimes[i].add(tally.regimes[i]);
  for (std::size_t i = 0; i < buckets.size(); ++i) buckets[i].add(tally.buckets[i]);
  for (std::size_t i = 0; i < explained.size(); ++i) {
    for (std::size_t r = 0; r < kRegimesMax; ++r) explained[i][r] += tally.explained[i][r];
  }
}

}  // namespace manifuzz
