#include "campaign/shrink_finding.hpp"

#include <array>
#include <atomic>

#include "campaign/in_child.hpp"
#include "process/shared_memory.hpp"

namespace manifuzz {
namespace {

bool is_lost(Verdict verdict) {
  return verdict == Verdict::crashed || verdict == Verdict::timed_out;
}

bool alike(const Judgement& judgement, const Judgement& root) {
  return judgement.bucket == root.bucket && judgement.explanation == root.explanation &&
         judgement.magnitude >= kMagnitudeShareKept * root.magnitude;
}

/// What a shrinking child has found so far, where its parent can see it even if it dies.
struct ShrinkSlot {
  std::atomic<int> evaluations{0};
  std::atomic<int> accepted{0};
  std::array<PairCase, 2> best;  ///< the one at `accepted` mod 2 is whole
  std::atomic<bool> complete{false};
};

void shrink_into(ShrinkSlot& slot, const PairCase& pair, const Judgement& root,
                 const std::function<Judgement(const PairCase&)>& judge_it) {
  const auto like_root = [&](const PairCase& candidate) {
    ++slot.evaluations;
    if (!alike(judge_it(candidate), root)) return false;
    slot.best[static_cast<std::size_t>(slot.accepted + 1) % 2] = candidate;
    ++slot.accepted;
    return true;
  };
  slot.complete = shrink(pair, like_root).complete;
}

}  // namespace

Shrunk shrink_finding(const PairCase& pair, const Collider& subject, const Collider& oracle,
                      Interruption& interruption) {
  const Judgement root = judge_in_child(pair, subject, oracle, interruption);
  Interruption shrinking(interruption.until_signal());
  const auto judge_it = [&](const PairCase& candidate) {
    return is_lost(root.bucket.verdict) ? judge_in_child(candidate, subject, oracle, shrinking)
                                        : judge(candidate, subject, oracle);
  };
  const Shared<ShrinkSlot> slot;
  slot->best[0] = pair;
  run_in_child([&] { shrink_into(*slot, pair, root, judge_it); }, case_seconds_max(subject, oracle),
               shrinking, [&] { return static_cast<std::uint64_t>(slot->evaluations); });
  return {slot->best[static_cast<std::size_t>(slot->accepted) % 2], slot->evaluations,
          slot->complete};
}

}  // namespace manifuzz
