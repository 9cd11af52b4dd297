#pragma once

#include "judging/compare.hpp"

namespace manifuzz {

// What the ledger's entries on Bullet and libccd look for: each recomputes what the named fault
// makes of the case, in double. A translation is a normal times its depth: what moves B away.

/// The normal is the direction of a translation that is right to rounding, but hardly longer than
/// its roundings.
bool direction_of_short_translation(const Deviation& deviation);

/// The same of libccd, which takes squares below CCD_EPS for 0: off by up to the root of it.
bool zero_of_squares(const Deviation& deviation);

/// Of Bullet's EPA: neither the pair nor the answer is deeper than GJK_MIN_DISTANCE, nor as far
/// apart, below which its GJK takes the origin for inside.
bool below_gjk_distance(const Deviation& deviation);
/// Of btGjkPairDetector: contact across a gap below gGjkEpaPenetrationTolerance, the solver's
/// distance with the sign of a depth.
bool gap_as_depth(const Deviation& deviation);
/// Of btMinkowskiPenetrationDepthSolver, of prisms: the normal is that one of its directions in the
/// plane along which they overlap least, and the depth what its displaced query makes of it; no
/// contact where the overlap is below 0.
bool least_of_fixed_directions(const Deviation& deviation);
/// The same, that query's distance too large by less than 0.01: its nearest corners are nearer to
/// each other than btVoronoiSimplexSolver tells apart.
bool least_of_fixed_directions_of_equal_vertices(const Deviation& deviation);
/// The same of flat shapes, of which it drops what the directions have along z: they are no longer
/// unit, and the short ones seem to have the least overlap. No contact, or the whole displacement
/// for a depth, where the displaced shapes still overlap.
bool least_of_flattened_directions(const Deviation& deviation);
bool least_of_flattened_directions_of_equal_vertices(const Deviation& deviation);

/// Of ccdGJKPenetration: epa_tolerance, a length, is compared with squares of lengths. The depth is
/// too small, by up to the tolerance over the depth, or the last corner is nearer than the root of
/// the tolerance to the chord that the answer is on.
bool tolerance_of_squares(const Deviation& deviation);

}  // namespace manifuzz
