#pragma once

#include <optional>
#include <vector>

#include "geometry/pair_case.hpp"

namespace manifuzz {

/// The numbers of a case that may be changed one at a time: all vertices, positions and radii.
std::vector<float*> free_numbers(PairCase& pair);

/// The case with its normals computed afresh, or none where its vertices, poses or radii are not
/// valid.
std::optional<PairCase> revalidated(PairCase pair);

}  // namespace manifuzz
