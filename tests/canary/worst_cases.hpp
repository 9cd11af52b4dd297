#pragma once

#include <map>
#include <string>
#include <utility>

#include "canary/blame.hpp"

namespace manifuzz::canary {

/// What a small campaign finds against a subject.
struct WorstCases {
  std::map<std::string, std::pair<Judgement, PairCase>> by_bucket;  ///< the worst of each
  int wrong = 0;                                                    ///< all cases
  int gross = 0;                                                    ///< of those
};

/// The worst of so many cases of all regimes, against Box2D.
WorstCases worst_cases(const Collider& subject, std::uint64_t seed, std::uint64_t cases);

}  // namespace manifuzz::canary
