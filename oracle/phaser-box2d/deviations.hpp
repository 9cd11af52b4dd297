#pragma once

#include "judging/ledger.hpp"

namespace manifuzz {

// What the ledger's entries on phaser-box2d look for beside Box2D's own faults: each recomputes
// what the named fault makes of the case, in double, and holds the answer against that within the
// collider's bounds.

/// A circle whose centre is within 1e-10 of a polygon: the normal is a face's, beyond its corner
/// too.
bool face_within_phaser_epsilon(const Deviation& deviation);
/// Two capsules in phaser-box2d: the answer is what b2CollideCapsules makes with u1X for u2X and
/// the greater of two ends for the lesser, and not what it makes without.
bool slips_in_phaser_capsules(const Deviation& deviation);
/// Two capsules in phaser-box2d: the answer is what b2CollideCapsules makes with or without these:
/// an edge's normal within 0.005 of the distance, points clipped along it, and one point alone
/// where a core's ends are both beyond the other's.
bool slop_in_phaser_capsules(const Deviation& deviation);
/// A circle whose centre is within 1e-10 of another core: the normal has no length.
bool no_normal_within_phaser_epsilon(const Deviation& deviation);
/// Two capsules in phaser-box2d whose cores are apart: the normal is the direction between their
/// nearest places as doubles have them, off by their roundings over the distance.
bool direction_of_rounded_places(const Deviation& deviation);
/// Edges all but parallel: the nearest places as doubles have them are corners though one is on an
/// edge, or the reverse; their distance is right to what the angle between both edges allows.
bool nearest_by_phaser_roundings(const Deviation& deviation);
/// No face is farther than a tenth of the slop: edges are clipped along a face's normal though the
/// cores are apart, and nearest at corners.
bool face_within_phaser_slop(const Deviation& deviation);
/// The normal between two corners is their difference over the distance of the same places as
/// shares of their edges give them: not unit, by the roundings of these over the distance.
bool normal_over_rounded_distance(const Deviation& deviation);
/// An incident edge that misses the slab, prolonged to it: a point off the polygon, or contact
/// across a gap.
bool edge_extended_to_slab(const Deviation& deviation);
/// The incident edge, along the reference face, is too short to be clipped.
bool incident_edge_unclipped(const Deviation& deviation);

}  // namespace manifuzz
