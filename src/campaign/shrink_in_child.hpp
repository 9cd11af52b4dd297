#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>

#include "campaign/in_child.hpp"
#include "process/pool.hpp"

namespace manifuzz {

/// What a shrinking child has found so far, where its parent can see it even if it dies.
template <class Slot>
struct ShrinkSlot {
  std::atomic<int> evaluations{0};
  std::atomic<int> accepted{0};
  std::array<Slot, 2> best;  ///< the one at `accepted` mod 2 is whole
  std::atomic<bool> complete{false};
};

/// How a finding's cases are shrunk. A `Slot` holds one in shared memory: it is assigned a case,
/// and gives it back.
template <class Slot, class Case>
struct ShrinkTask {
  const Case& start;
  bool is_here = false;    ///< candidates are asked about from this process, not from a child
  double seconds_max = 0;  ///< over a candidate, in a child
  Deadline deadline{};
  std::function<bool(const Case& candidate, Interruption& shrinking)> is_alike;

  /// The smallest that is alike, by `shrink` of such cases. Ends early, with the smallest so far,
  /// at the deadline, and at the first signal from now on.
  auto run(Interruption& interruption) const {
    Interruption::Limits limits = interruption.until_signal();
    limits.stopped_at = earlier(limits.stopped_at, deadline);
    Interruption shrinking(limits);
    const Shared<ShrinkSlot<Slot>> slot;
    slot->best[0] = start;
    const auto still_fails = [&](const Case& candidate) {
      if (is_here && shrinking.is_stopped()) throw Interrupted();
      ++slot->evaluations;
      if (!is_alike(candidate, shrinking)) return false;
      slot->best[static_cast<std::size_t>(slot->accepted + 1) % 2] = candidate;
      ++slot->accepted;
      return true;
    };
    const auto shrink_it = [&] { slot->complete = shrink(start, still_fails).complete; };
    if (is_here) {
      unless_interrupted(shrink_it);
    } else {
      run_in_child(shrink_it, seconds_max, shrinking,
                   [&] { return static_cast<std::uint64_t>(slot->evaluations); });
    }
    return decltype(shrink(start, still_fails)){
        Case(slot->best[static_cast<std::size_t>(slot->accepted) % 2]), slot->evaluations,
        slot->complete};
  }
};

}  // namespace manifuzz
