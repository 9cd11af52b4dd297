#pragma once

#include <optional>

#include "base/random.hpp"
#include "geometry/pair_case.hpp"

namespace manifuzz {

/// Shares from 0 to 1.
struct BreedShares {
  double of_numbers = 0.25;  ///< moves of a single number, among all moves
  double renumbered = 0.25;  ///< cases whose faces are counted from another one
};

/// What becomes of a case by up to four moves, or nothing where they leave no valid one.
std::optional<PairCase> bred(Random& random, const PairCase& parent, const PairCase& mate,
                             const BreedShares& shares);

/// Whether the shapes have sizes and places that somebody may use: 2^-24 to 2^24, and up to 2^30
/// from the origin. Beyond, engines' own absolute lengths are all that is found.
bool is_in_use(const PairCase& pair);

}  // namespace manifuzz
