#pragma once

#include "judging/ledger.hpp"

namespace manifuzz {

// What the ledger's entries on Bullet look for: each recomputes what the named fault makes of
// the case, in double, and holds the answer against that within the collider's bounds. A
// translation is a normal times its depth: what moves B away.

/// The normal is the direction of a translation that is right to rounding, but hardly longer than
/// its roundings.
bool direction_of_short_translation(const Deviation& deviation);
/// Bullet's EPA: neither the pair nor the answer is deeper than GJK_MIN_DISTANCE, nor as far
/// apart, below which its GJK takes the origin for inside.
bool below_gjk_distance(const Deviation& deviation);
/// btGjkPairDetector: contact across a gap below gGjkEpaPenetrationTolerance, the solver's
/// distance with the sign of a depth.
bool gap_as_depth(const Deviation& deviation);
/// btMinkowskiPenetrationDepthSolver on prisms: the normal is that one of its directions in the
/// plane along which they overlap least, and the depth what its displaced query makes of it; no
/// contact where the overlap is below 0.
bool least_of_fixed_directions(const Deviation& deviation);
/// The same, that query's distance too large by less than 0.01: its nearest corners are nearer to
/// each other than btVoronoiSimplexSolver tells apart.
bool least_of_fixed_directions_of_equal_vertices(const Deviation& deviation);
/// btMinkowskiPenetrationDepthSolver on flat shapes, of which it drops what the directions have
/// along z: they are no longer unit, and the short ones seem to have the least overlap. No contact,
/// or the whole displacement for a depth, where the displaced shapes still overlap.
bool least_of_flattened_directions(const Deviation& deviation);
bool least_of_flattened_directions_of_equal_vertices(const Deviation& deviation);

}  // namespace manifuzz
