#pragma once

#include <functional>

#include "geometry/pair_case.hpp"

namespace manifuzz {

struct Shrunk {
  PairCase pair;
  int evaluations = 0;   ///< how often the predicate ran
  bool complete = true;  ///< false where the limit came before the minimum
};

inline constexpr int kShrinkEvaluations = 20'000;

/// The smallest case that `still_fails`, by steps from `pair` to one of its `simpler_cases` that
/// still fails too; `pair` itself at worst. No case is tried twice. Deterministic.
Shrunk shrink(const PairCase& pair, const std::function<bool(const PairCase&)>& still_fails,
              int evaluations_max = kShrinkEvaluations);

}  // namespace manifuzz
