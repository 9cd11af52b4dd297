#pragma once

#include <tuple>

#include "corpus/corpus.hpp"
#include "corpus/shrink.hpp"

namespace manifuzz {

/// The order in which cases of one bucket are preferred, the best first: the simplest, as shrinking
/// has it, and of cases that are as simple the one with the greatest error.
inline auto preference(const CorpusCase& known) {
  const Complexity complexity_of_case = complexity(known.pair);
  const double magnitude = known.expect ? known.expect->magnitude.value_or(-1) : -1;
  return std::tuple(known.frames.size(), simplicity(complexity_of_case), -magnitude,
                    complexity_of_case);
}

}  // namespace manifuzz
