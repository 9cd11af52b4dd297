#pragma once

#include <functional>

#include <rapidcheck.h>

#include "geometry/pair_case.hpp"

namespace manifuzz {

/// Every simpler case next to this one, the boldest first: the plainest cases there are, then
/// without a vertex, with identity poses, with fewer digits, with smaller numbers, and the
/// symmetric image that is simplest. All valid, all of less `complexity`. Lazy.
rc::Seq<PairCase> simpler_cases(const PairCase& pair);

/// The tree that RapidCheck walks: each case above its simpler ones.
rc::Shrinkable<PairCase> shrink_tree(const PairCase& pair);

struct Shrunk {
  PairCase pair;
  int evaluations = 0;   ///< how often the predicate ran
  bool complete = true;  ///< false where the limit came before the minimum
};

inline constexpr int kShrinkEvaluations = 20'000;

/// The smallest case under `pair` in the shrink tree that `still_fails`; `pair` itself at worst. No
/// case is tried twice. Deterministic.
Shrunk shrink(const PairCase& pair, const std::function<bool(const PairCase&)>& still_fails,
              int evaluations_max = kShrinkEvaluations);

}  // namespace manifuzz
