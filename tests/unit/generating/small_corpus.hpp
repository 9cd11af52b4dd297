#pragma once

#include <vector>

#include "generating/regime.hpp"

namespace manifuzz {

/// A corpus for the regime of that name: it must not depend on what the repository has saved.
inline std::vector<PairCase> small_corpus() {
  std::vector<PairCase> pairs;
  for (const auto* name : {"generic", "grid", "sliver", "tie_bias", "deep"}) {
    for (std::uint64_t i = 0; i < 8; ++i) pairs.push_back(generate(7, *find_regime(name), i));
  }
  return pairs;
}

}  // namespace manifuzz
