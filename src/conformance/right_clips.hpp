#pragma once

#include <string>

#include "exact/truth.hpp"

namespace manifuzz {

/// Appends `"empty": [...], "right": [...]` of polygons with sharp corners, which the clips decide:
/// the scalars in which no contact is right, and each right manifold with the bounds of every
/// scalar in which it is. All figures are in A's frame, depths world lengths.
void append_right_clips(std::string& out, const exact::Truth& truth);

}  // namespace manifuzz
