#pragma once

#include <array>

#include "geometry/convex_polygon.hpp"

namespace manifuzz {

/// A number for each corner, or face, of a polygon: lanes-inl.hpp computes with all at once.
using LaneArray = std::array<double, kMaxVertices>;

}  // namespace manifuzz
