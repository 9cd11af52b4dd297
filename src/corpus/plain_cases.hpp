#pragma once

#include <vector>

#include "geometry/pair_case.hpp"

namespace manifuzz {

/// The plainest cases there are of a pair's kind, the simplest first: triangles at the origin, with
/// radii where it has some, or where it is round circles, segments and capsules. What fails in any
/// such case has one normal form, wherever it was found.
const std::vector<PairCase>& plain_cases(const PairCase& pair);

}  // namespace manifuzz
