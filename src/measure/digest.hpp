#pragma once

#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "collider/collider.hpp"
#include "process/interruption.hpp"

namespace manifuzz {

/// Whose answers are hashed, and to which cases.
struct DigestPlan {
  Collider collider;
  std::uint64_t seed = 1;
  std::uint64_t cases = 10'000;  ///< of each regime
};

struct RegimeDigest {
  std::string_view regime;
  std::uint64_t contacts = 0;  ///< answers that say that they touch
  std::uint64_t lost = 0;      ///< answers that never came, or made no sense
  std::uint64_t hash = 0;
};

/// Every bit of a collider's answers, as one number a regime and one over all: equal numbers, equal
/// bits. What is hashed is what it said, in double, wherever it runs and whatever ran it.
struct Digest {
  std::vector<RegimeDigest> regimes;
  std::uint64_t hash = 0;  ///< over the regimes' names and hashes
};

/// `progress` gets the number of cases done, now and then. Throws UserError where the interruption
/// stops it, or the collider gives no answers again and again, or none to a whole regime.
Digest digest(const DigestPlan& plan, Interruption& interruption,
              const std::function<void(std::uint64_t)>& progress);

}  // namespace manifuzz
