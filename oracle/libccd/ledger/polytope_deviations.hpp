#pragma once

#include "judging/ledger.hpp"

namespace manifuzz {

// What the ledger's entries on ccdGJKPenetration look for that repeat it in its own doubles, in
// space: the answer is that of the repeated one, and the polytope was left as named.

/// What another predicate looks for, where the answer is the repeated one.
bool is_of_ccd(const Deviation& deviation);
template <bool (*explains)(const Deviation&)>
bool by_ccd(const Deviation& deviation) {
  return explains(deviation) && is_of_ccd(deviation);
}

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
/// The polytope that it begins with does not hold the origin, or has it on its surface: the steps
/// of GJK compare sums that are rounded by more than CCD_EPS.
bool polytope_without_origin(const Deviation& deviation);
/// Epa stops at a polytope about two corners: the four others do not go round the line between
/// them, so that its triangles are folded.
bool polytope_folded(const Deviation& deviation);
/// No contact: a tetrahedron seems flat, or a direction of no length, by a square below CCD_EPS.
bool apart_by_zero(const Deviation& deviation);

/// The nearest element is the origin itself, and ccdGJKPenetration divides its place by its length.
bool direction_of_no_length(const LostAnswer& lost);
/// Expansions repeat themselves, and nothing counts them.
bool polytope_expanded_for_ever(const LostAnswer& lost);

}  // namespace manifuzz
