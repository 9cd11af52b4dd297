#pragma once

#include <functional>
#include <set>
#include <vector>

#include <rapidcheck.h>

namespace manifuzz {

/// What every candidate of shrinking has to pass: none is tried twice, nor more than so many.
template <class Case>
struct ShrinkGate {
  const std::function<bool(const Case&)>& still_fails;
  int evaluations_max = 0;
  std::set<std::vector<float>> seen;  ///< the `numbers_of` those that were tried
  int evaluations = 0;
  bool complete = true;  ///< false where the limit came before the minimum

  bool fails(const Case& candidate) {
    ++evaluations;
    return still_fails(candidate);
  }
  bool passes(const Case& candidate) {
    if (!complete || !seen.insert(numbers_of(candidate)).second) return false;
    complete = evaluations < evaluations_max;
    return complete && fails(candidate);
  }
};

/// The smallest case that passes, by steps from `start` to one that `simpler` gives.
template <class Case, class Simpler>
Case smallest(const Case& start, const Simpler& simpler, ShrinkGate<Case>& gate) {
  const auto tree = rc::shrinkable::shrinkRecur(start, simpler);
  return rc::shrinkable::findLocalMin(tree,
                                      [&](const Case& candidate) { return gate.passes(candidate); })
      .first;
}

}  // namespace manifuzz
