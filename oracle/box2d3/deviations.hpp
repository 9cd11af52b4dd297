#pragma once

#include "judging/ledger.hpp"

namespace manifuzz {

// What the ledger's entries on Box2D 3.2 look for: the engine's operations are repeated in its own
// scalar and order, and give the answer; with the named fault mended they give a right one.

/// Cores are nearest at a vertex of each, and of the clip of their edges one point is given.
bool one_point_between_corners(const Deviation& deviation);
/// A circle whose centre is within float's epsilon of another core in Box2D 3.2: the normal has no
/// length.
bool no_normal_within_box2d3_epsilon(const Deviation& deviation);
/// Two capsules in Box2D 3.2: the answer is what b2CollideCapsules makes, which is as
/// phaser-box2d's without the slips, but that A's edge is kept up to 0.0005.
bool slop_in_box2d3_capsules(const Deviation& deviation);
/// A circle and a segment, a capsule or a polygon's corner in Box2D 3.2: the normal is the
/// direction to the place on the core that is nearest as floats have it.
bool direction_of_rounded_place(const Deviation& deviation);
/// A circle in front of faces that tie in floats: the normal is the direction from the end of the
/// one that Box2D 3.2 keeps, though the centre is in front of another.
bool corner_of_tied_face(const Deviation& deviation);
/// Two capsules: with the slop, the bias to A's edge and the one point that doubles have too.
bool capsules_of_box2d3(const Deviation& deviation);
/// Two capsules: floats decide otherwise than doubles which side, end or place is nearer, or make
/// another normal of the direction between nearest places.
bool roundings_in_box2d3_capsules(const Deviation& deviation);
/// No contact though corners with radii overlap: no face of either core is farther than 0.0005,
/// and the incident edge is beyond the reference face's ends.
bool corner_beyond_slab(const Deviation& deviation);
/// A round pair with a polygon: edges are clipped along a face's normal though a vertex of each is
/// nearer.
bool face_within_box2d3_slop(const Deviation& deviation);
/// The normal between two corners is their difference over the distance of the same places as
/// shares of their edges give them: not unit, by the roundings of these over the distance.
bool normal_over_box2d3_distance(const Deviation& deviation);
/// An answer that holds no number: the distance of the nearest places is 0, and their difference is
/// divided by it.
bool normal_over_no_distance(const LostAnswer& lost);
/// An answer that holds no number: of two capsules, the product of both cores' squared lengths is
/// beyond a float, and the nearest places are shares of infinity over infinity.
bool squares_beyond_box2d3_range(const LostAnswer& lost);
/// The incident edge is shorter along the face than float's epsilon, and not clipped.
bool edge_below_box2d3_epsilon(const Deviation& deviation);
/// No contact: edges that are apart miss each other along the reference face, by roundings, and are
/// nearest, by roundings, not at their ends.
bool neither_clipped_nor_corner(const Deviation& deviation);

}  // namespace manifuzz
