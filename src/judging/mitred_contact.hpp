#pragma once

#include "exact/curve.hpp"

namespace manifuzz {

/// Whether mitred skins that touch may do so where no contact point can be: along the normal of a
/// face that has the least depth, to within `minimality`, the deepest places are farther apart
/// along the tangent than both skins reach, less `along` each; world lengths. bounds.md, "Corners
/// of mitred skins".
bool may_touch_beyond_skins(const exact::Truth& truth, const exact::PenetrationCurve& curve,
                            double minimality, double along);

}  // namespace manifuzz
