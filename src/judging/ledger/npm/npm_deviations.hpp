#pragma once

#include "judging/compare.hpp"

namespace manifuzz {

// What the ledger's entries on engines asked through npm look for; those that are Box2D's or
// planck's faults too are in ledger/box2d.

/// @box2d/core: B's face clips, and each point's feature of B is that of A; all else is right.
bool features_lost_by_two_assignments(const Deviation& deviation);
/// @box2d/core: a face shorter than 1e-5, whose direction is not normalised: the normal is as short
/// as the face, and depths are next to none.
bool normal_of_short_face(const Deviation& deviation);
/// @box2d/core: a circle whose centre is within 1e-5 of another's or of an edge's end: the normal
/// is the world's x axis.
bool axis_within_box2d_core_epsilon(const Deviation& deviation);
/// @box2d/core: a circle whose centre is within 1e-5 of a polygon: the normal is a face's, beyond
/// its corner too.
bool face_within_box2d_core_epsilon(const Deviation& deviation);

// Of matter-js, whose operations are repeated: the answer is what they give.

/// The normal has the sign that the centres give, which is not that of the least overlap.
bool normal_by_matter_centres(const Deviation& deviation);
/// A face whose gradient is another's to three decimals has less overlap than the axis taken, or
/// would be right in its place.
bool axes_merged_by_matter(const Deviation& deviation);
/// No support vertex of either is inside the other: the point is A's.
bool vertex_outside_by_matter(const Deviation& deviation);
/// The deepest vertex is not inside the other, or was not asked: nobody is as deep as is said.
bool deepest_left_out_by_matter(const Deviation& deviation);
/// Too few points, too near each other, or one on a far side: beside the deepest vertex the deeper
/// of its neighbours is taken, which is not the end of the edge that faces the other body.
bool neighbour_by_depth_of_matter(const Deviation& deviation);
/// The same with the right edges: their ends that are inside the other body are given, and no
/// place where an edge is cut.
bool vertices_inside_alone_by_matter(const Deviation& deviation);

// Of p2 on circles, whose operations are repeated: the answer is what they give.

/// A normal without length, and no depth: what it is made of is (0, 0).
bool zero_normal_of_p2(const Deviation& deviation);
/// A centre on a capsule's core, but for roundings: the sign of the normal is theirs, and the sign
/// with which the capsule's radius counts; at an end, the direction.
bool direction_of_roundings_of_p2(const Deviation& deviation);
/// A capsule's first end, where another place of its core is nearer.
bool first_end_of_p2(const Deviation& deviation);
/// A capsule's normal is that of its ends as floats have them in the world: off by their roundings
/// over its length.
bool edge_of_rounded_ends_in_p2(const Deviation& deviation);
/// A face's contact where a vertex is the nearest, or another face.
bool face_before_vertex_of_p2(const Deviation& deviation);
/// A vertex' contact, or none, where a face is the nearest: the circle's own point behind that face
/// is outside of the polygon.
bool vertex_before_face_of_p2(const Deviation& deviation);

/// nape: the shapes that were used are those which its rule of corners that lie together, or on a
/// line, leaves of the case's.
bool corners_spliced_by_nape(const Deviation& deviation);
/// nape: a circle whose centre is within 1e-8 of another's or of a corner: the normal is against
/// the world's x axis, the depth that of two points at one place, and the point the centre.
bool axis_within_nape_epsilon(const Deviation& deviation);
/// nape: an end of the incident edge is not cut, being beyond a side plane by less than 1e-8 of the
/// edge's length.
bool unclipped_within_nape_epsilon(const Deviation& deviation);
/// nape: the incident edge misses the slab, or is along the normal but for roundings, and the
/// answer is of it as prolonged to both side planes; if no end left the edge it would be right.
bool edge_extended_by_nape(const Deviation& deviation);
/// nape: an answer that holds no number, for the incident edge has no run along the face, and it
/// divides by that.
bool edge_of_no_run_in_nape(const LostAnswer& lost);

}  // namespace manifuzz
