#pragma once

#include <string>

#include "exact/truth.hpp"

namespace manifuzz {

/// Appends `"empty": [...], "round": {...}` of a pair with a round shape, which the penetration
/// curve decides: the scalars in which no contact is right, the least depth D*, and for every
/// scalar in which a contact is right what its normal, depth and points must be, within bounds.
/// Normals are in the world, all figures world lengths. False, and nothing appended, where the
/// second point depends on which of several right normals an answer has.
bool append_right_round(std::string& out, const exact::Truth& truth);

}  // namespace manifuzz
