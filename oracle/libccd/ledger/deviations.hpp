#pragma once

#include "judging/ledger.hpp"

namespace manifuzz {

// What faults of libccd make of the case in double, whatever its GJK does; the answer is held
// against that within the collider's bounds. A translation is a normal times its depth: what moves
// B away.

/// The translation is right but for squares below CCD_EPS, which libccd takes for 0: off by up to
/// the root of it.
bool zero_of_squares(const Deviation& deviation);
/// ccdGJKPenetration: epa_tolerance, a length, is compared with squares of lengths. The depth is
/// too small, by up to the tolerance over the depth, or the last corner is nearer than the root of
/// the tolerance to the chord that the answer is on.
bool tolerance_of_squares(const Deviation& deviation);

}  // namespace manifuzz
