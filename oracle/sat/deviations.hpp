#pragma once

#include "judging/ledger.hpp"

namespace manifuzz {

// What the ledger's entries on SAT.js look for: the engine's operations are repeated in its own
// scalar and order, and give the answer; with the named fault mended they give a right one.

/// SAT.js 0.9.0: of polygons that just touch the overlap is 0, and the axis is not turned about.
bool axis_of_exact_touch_in_sat(const Deviation& deviation);
/// SAT.js 0.9.0: the centres of two circles are at one place, and the normal has no length.
bool no_normal_of_one_centre_in_sat(const Deviation& deviation);

}  // namespace manifuzz
