#pragma once

#include "judging/compare.hpp"

namespace manifuzz {

// What the ledger's entries on ccdGJKPenetration look for that repeat it in its own doubles, in
// space: the answer is that of the repeated one, and the polytope was left as named.

/// nextSupport compared the tolerance, a length, with a product or a square of lengths that was
/// below it, though what they are of is longer: an element inside the difference.
bool polytope_left_by_squares(const Deviation& deviation);
/// The corner that it asked for next is one of the element's own, within the tolerance: expansion
/// replaces one triangle, which leaves the polytope not convex.
bool polytope_left_at_own_corner(const Deviation& deviation);
/// The nearest element's square is 0, for an element inside the difference that the origin is on.
bool polytope_left_at_zero(const Deviation& deviation);
/// A simplex that touches the origin was taken for the difference's boundary.
bool polytope_left_touching(const Deviation& deviation);

}  // namespace manifuzz
