#pragma once

#include <optional>

#include "base/random.hpp"
#include "geometry/pair_case.hpp"

namespace manifuzz {

/// What becomes of a case by up to four moves, or nothing where they leave no valid one. A move is
/// of a single number in so large a share.
std::optional<PairCase> bred(Random& random, const PairCase& parent, const PairCase& mate,
                             double share_of_numbers);

/// Whether the shapes have sizes and places that somebody may use: 2^-24 to 2^24, and up to 2^30
/// from the origin. Beyond, engines' own absolute lengths are all that is found.
bool is_in_use(const PairCase& pair);

}  // namespace manifuzz
