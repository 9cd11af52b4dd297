#pragma once

#include <rapidcheck.h>

#include "geometry/pair_case.hpp"

namespace manifuzz {

/// Every simpler case next to this one, the boldest first: the plainest cases there are, then
/// without a vertex, with identity poses, with fewer digits, with smaller numbers, and the
/// symmetric image that is simplest. All valid, all of less `complexity`. Lazy.
rc::Seq<PairCase> simpler_cases(const PairCase& pair);

/// The case with 0 in place of -0: as simple cases have it.
PairCase without_negative_zeros(PairCase pair);

}  // namespace manifuzz
