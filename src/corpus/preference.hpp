#pragma once

#include <tuple>

#include "corpus/corpus.hpp"
#include "corpus/shrink.hpp"

namespace manifuzz {

/// The pair that a case begins with.
inline PairCase beginning(const PairCase& pair) {
  return pair;
}
inline PairCase beginning(const Sequence& sequence) {
  return sequence.at(0);
}

/// The order in which cases of one bucket are preferred, the best first: the simplest, as shrinking
/// has it, and of cases that are as simple the one with the greatest error.
inline auto preference(const CorpusCase& known) {
  const Complexity complexity_of_case =
      complexity(std::visit([](const auto& one) { return beginning(one); }, known.any));
  const double magnitude = known.expect ? known.expect->magnitude.value_or(-1) : -1;
  return std::tuple(frames_in(known.any), simplicity(complexity_of_case), -magnitude,
                    complexity_of_case);
}

}  // namespace manifuzz
