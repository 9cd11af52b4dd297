#pragma once

#include "judging/compare.hpp"

namespace manifuzz {

/// Of ccdMPRPenetration: the origin is on the segment from the difference's middle to its corner
/// that is farthest beyond it, or is that middle. The translation is to this corner, not to the
/// face that it is on.
bool translation_to_corner_of_ray(const Deviation& deviation);

}  // namespace manifuzz
