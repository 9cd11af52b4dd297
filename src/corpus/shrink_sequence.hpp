#pragma once

#include <functional>
#include <vector>

#include "corpus/shrink.hpp"
#include "geometry/sequence.hpp"

namespace manifuzz {

/// How hard a sequence is to read: by its frames first, then as a case is.
struct SequenceComplexity {
  std::size_t frames = 0;
  Complexity of_numbers;  ///< of both shapes, and of what stands in any frame

  friend auto operator<=>(const SequenceComplexity&, const SequenceComplexity&) = default;
};

SequenceComplexity complexity(const Sequence& sequence);

/// All that tells two sequences apart.
std::vector<float> numbers_of(const Sequence& sequence);

struct ShrunkSequence {
  Sequence sequence;
  int evaluations = 0;   ///< how often the predicate ran
  bool complete = true;  ///< false where the limit came before the minimum
};

/// The smallest sequence that `still_fails`: without half of its frames, a quarter, ..., one, from
/// the end, from the start and between; then the plainest there are, a box on a box; with plain
/// shapes, less motion, plain turns; then with what makes a case simpler done in all frames alike,
/// and in one. No sequence is tried twice. Deterministic.
ShrunkSequence shrink(const Sequence& sequence,
                      const std::function<bool(const Sequence&)>& still_fails,
                      int evaluations_max = kShrinkEvaluations);

}  // namespace manifuzz
