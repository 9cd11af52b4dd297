#pragma once

#include "judging/ledger.hpp"

namespace manifuzz::ledger_of {

/// How Bullet was asked: prisms with its EPA or with its fixed directions, or flat hulls with
/// these.
enum class BulletAsked { epa, directions, flat };

/// What oracle/bullet/epa.cpp declares.
Declaration declaration_of_epa();

// What faults of Bullet make of the case in double, whatever its query does; the answer is held
// against that within the collider's bounds. A translation is a normal times its depth: what moves
// B away.

/// The normal is the direction of a translation that is right to rounding, but hardly longer than
/// its roundings.
bool direction_of_short_translation(const Deviation& deviation);
/// Bullet's EPA: neither the pair nor the answer is deeper than GJK_MIN_DISTANCE, nor as far
/// apart, below which its GJK takes the origin for inside.
bool below_gjk_distance(const Deviation& deviation);
/// btGjkPairDetector: contact across a gap below gGjkEpaPenetrationTolerance, the solver's
/// distance with the sign of a depth.
bool gap_as_depth(const Deviation& deviation);
/// btMinkowskiPenetrationDepthSolver: the normal is that one of its directions along which they
/// overlap least, and the depth what its displaced query makes of it; no contact where the overlap
/// is below 0. Of prisms these are the directions in the plane. Of flat shapes it drops what the
/// directions have along z: they are no longer unit, and the short ones seem to have the least
/// overlap; where the displaced shapes still overlap there is no contact, or the whole displacement
/// for a depth.
bool is_of_least_direction(const Deviation& deviation, BulletAsked asked);
/// btMinkowskiPenetrationDepthSolver, whose displaced query's distance is too large by less than
/// 0.01: its nearest corners are nearer to each other than btVoronoiSimplexSolver tells apart.
bool is_of_least_direction_of_equal_vertices(const Deviation& deviation, BulletAsked asked);

}  // namespace manifuzz::ledger_of
