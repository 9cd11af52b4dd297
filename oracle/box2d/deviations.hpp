#pragma once

#include "judging/ledger.hpp"

namespace manifuzz {

// What the ledger's entries on Box2D 2.4, and on the engines that descend from it, look for: in the
// judge's terms of polygons; of round shapes each recomputes what the named fault makes of
// the case, in double, and holds the answer against that within the collider's bounds.

/// No contact for overlapping polygons: the bias keeps A's shallower face, whose slab misses.
bool no_contact_under_bias(const Deviation& deviation);
/// The reference face is too short for b2Vec2::Normalize, or shorter than world coordinates
/// resolve.
bool tiny_reference_face(const Deviation& deviation);
/// The square of the reference face's length is beyond float, so that b2Vec2::Normalize divides by
/// infinity.
bool huge_reference_face(const Deviation& deviation);
/// An end of the incident edge lies so near a side plane that the product of both ends' distances
/// underflows: the crossing is not seen, and one point is left.
bool crossing_underflows(const Deviation& deviation);
/// An edge against a polygon, clipped between the very ends of the reference face: the deepest
/// vertex lies beyond them, within the radii, and is cut off.
bool edge_slab_not_widened(const Deviation& deviation);
/// An edge against a polygon: the edge's own face is kept though one of the polygon's has a greater
/// separation, by no more than 2 % of the edge's depth and 0.001.
bool edge_face_kept_by_hysteresis(const Deviation& deviation);
/// An edge against a polygon: of the polygon's edges that face the edge's face alike, one is
/// clipped that has not the deepest vertex.
bool edge_clips_tied_incident(const Deviation& deviation);
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
/// A circle in front of faces that tie in floats: the one that Box2D 2.4 keeps is not the farthest,
/// so that the normal is its own, or the direction from its end.
bool tied_face_of_box2d_circle(const Deviation& deviation);
/// As `tiny_reference_face`, or a circle against an edge that is shorter than epsilon: what Box2D
/// 2.4 makes of it is the edge's normal, as short as the edge.
bool tiny_reference_face_of_box2d(const Deviation& deviation);

}  // namespace manifuzz
