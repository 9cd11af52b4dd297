#pragma once

#include "judging/ledger.hpp"

namespace manifuzz {

// Faults of b2CollidePolygons on round shapes, whose operations are repeated in double.

/// No face is farther than a tenth of the slop: edges are clipped along a face's normal though the
/// cores are apart, and nearest at corners.
bool face_within_phaser_slop(const Deviation& deviation);
/// The normal between two corners is their difference over the distance of the same places as
/// shares of their edges give them: not unit, by the roundings of these over the distance.
bool normal_over_rounded_distance(const Deviation& deviation);
/// Edges all but parallel: the nearest places as doubles have them are corners though one is on an
/// edge, or the reverse; their distance is right to what the angle between both edges allows.
bool nearest_by_phaser_roundings(const Deviation& deviation);

}  // namespace manifuzz
