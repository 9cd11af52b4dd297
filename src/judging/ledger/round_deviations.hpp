#pragma once

#include "judging/compare.hpp"

namespace manifuzz {

// What the ledger's entries on round shapes look for: each recomputes what the named fault makes of
// the case, in double, and holds the answer against that within the collider's bounds.

/// An edge against a polygon, clipped between the very ends of the reference face: the deepest
/// vertex lies beyond them, within the radii, and is cut off.
bool edge_slab_not_widened(const Deviation& deviation);
/// An edge against a polygon: the edge's own face is kept though one of the polygon's has a greater
/// separation, by no more than 2 % of the edge's depth and 0.001.
bool edge_face_kept_by_hysteresis(const Deviation& deviation);
/// A circle whose centre is nearer than epsilon to the end of an edge: the normal is the world's x
/// axis, towards the circle, wherever the edge lies.
bool axis_for_coincident_points(const Deviation& deviation);
/// A circle whose centre lies on an edge's end or a polygon's corner: the normal is the direction
/// between both as floats have them, which is that of their roundings.
bool direction_of_roundings(const Deviation& deviation);
/// A circle whose centre is nearer than epsilon to a polygon's corner: the normal is as short as
/// their distance, since b2Vec2::Normalize leaves it so, and the depth is taken along it, or the
/// distance along it from the radii.
bool corner_direction_not_normalised(const Deviation& deviation);
/// A circle whose centre is in front of a polygon by less than epsilon: what Box2D 2.4 makes of it
/// is a face's normal, beyond its corner too, and it would be right without that epsilon.
bool face_within_box2d_epsilon(const Deviation& deviation);
/// As `tiny_reference_face`, or a circle against an edge that is shorter than epsilon: what Box2D
/// 2.4 makes of it is the edge's normal, as short as the edge.
bool tiny_reference_face_of_box2d(const Deviation& deviation);

/// cpShapesCollide put the shapes into its own order: distances have the wrong sign, so that
/// depths are lost; all else is right.
bool sign_of_swapped_distance(const Deviation& deviation);
/// A circle against a polygon, whose radius is taken from the depth instead of being added.
bool sign_of_polygon_radius(const Deviation& deviation);
/// A circle against a segment: the normal is the direction to the place on it that is nearest as
/// doubles have it, however short.
bool direction_to_place_on_segment(const Deviation& deviation);
/// A corner of one core lies on one of the other's: the normal is across a chord of their
/// difference that ends there.
bool normal_across_corner_on_corner(const Deviation& deviation);
/// A corner of one core lies on one of the other's: the normal is the direction between both as
/// doubles have it, which is that of their roundings, or perpendicular to the chord between two
/// such differences, which is as short.
bool direction_between_corners(const Deviation& deviation);
/// A circle whose centre lies on a segment: the normal is the segment's, as much longer than unit
/// as its rotation is.
bool segment_normal_not_unit(const Deviation& deviation);
/// The normal is across a chord of the cores' difference on whose line, but beyond it, the origin
/// lies.
bool normal_across_collinear(const Deviation& deviation);
/// The depth of an end was found by a division by its edge's run along the tangent, which is short:
/// it is off by that much more, or the wrong end was taken of an edge along the normal.
bool depth_by_crossing(const Deviation& deviation);

/// What Chipmunk and its ports declare.
const Declaration& as_chipmunk();
/// Munk2D: a normal without length. Boxes around both shapes have one middle, so that GJK begins
/// with one support point twice.
bool zero_normal_of_one_middle(const Deviation& deviation);
/// cp: a normal that is shorter than unit as 1e-15 beside the length that it is divided by makes
/// it, and right else, or wrong in a way of Chipmunk's.
bool normal_short_by_cp(const Deviation& deviation);

/// jbox2d: no contact of an edge and a polygon that are farther apart than 0.02, the radii that it
/// takes for theirs.
bool edge_radius_of_settings(const Deviation& deviation);

/// An edge against a polygon in planck, clipped between the very ends of the reference face.
bool planck_edge_slab_not_widened(const Deviation& deviation);
/// The same, where the face is not the one of the greatest separation: the edge's towards the
/// polygon's centroid, or whichever 0.98 times the edge's separation and 0.001 decide for.
bool planck_edge_hysteresis(const Deviation& deviation);
/// A circle whose centre is within 1e-9 of another's or of an edge's end: the normal is the world's
/// x axis.
bool axis_within_planck_epsilon(const Deviation& deviation);
/// A circle whose centre is within 1e-9 of a polygon: the normal is a face's, beyond its corner
/// too.
bool face_within_planck_epsilon(const Deviation& deviation);
/// The same in phaser-box2d, within 1e-10.
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

// Of Box2D 3.2, whose operations are repeated in floats: the answer is what they give.

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

// Of b2CollidePolygons, whose operations are repeated: the answer is what they give.

/// Edges all but parallel: the nearest places as doubles have them are corners though one is on an
/// edge, or the reverse; their distance is right to what the angle between both edges allows.
bool nearest_by_phaser_roundings(const Deviation& deviation);
/// No face is farther than a tenth of the slop: edges are clipped along a face's normal though the
/// cores are apart, and nearest at corners.
bool face_within_phaser_slop(const Deviation& deviation);
/// The normal between two corners is their difference over the distance of the same places as
/// shares of their edges give them: not unit, by the roundings of these over the distance.
bool normal_over_rounded_distance(const Deviation& deviation);

}  // namespace manifuzz
