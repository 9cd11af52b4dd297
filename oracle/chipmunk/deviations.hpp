#pragma once

#include <vector>

#include "judging/faults/shared_faults.hpp"
#include "oracle/chipmunk/replay.hpp"

namespace manifuzz {

// What the ledger's entries on Chipmunk, and on the engines that descend from it, look for: in the
// judge's terms of polygons; of round shapes each recomputes what the named fault makes of
// the case, in double, and holds the answer against that within the collider's bounds.

/// The normal is arbitrary, or the contact missed, and a corner of A lies on a corner of B.
bool corner_on_corner(const Deviation& deviation);
/// Contact for polygons that are apart, and the origin lies on the line through two of their
/// difference's corners, beyond them.
bool collinear_and_apart(const Deviation& deviation);
/// Neighbouring faces of a polygon with sharp corners are nearer in direction than a dot product
/// can tell, and the clip is wrong.
bool neighbours_nearly_parallel(const Deviation& deviation);
/// The neighbour of the right face is clipped: as above, or by a replay that is right with the edge
/// that is turned least.
bool wrong_support_edge(const munk::Port& port, const Deviation& deviation);
/// cpShapesCollide put the shapes into its own order: distances have the wrong sign, so that
/// depths are lost; all else is right.
bool sign_of_swapped_distance(const Deviation& deviation);
/// A circle against a polygon, whose radius is taken from the depth instead of being added.
bool sign_of_polygon_radius(const Deviation& deviation);
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
/// Corners are rounded in the world, where a polygon may lose its width: about A's position the
/// same steps give a right answer.
bool rounded_in_the_world(const munk::Port& port, const Deviation& deviation);
/// The nearest place on a long edge of the difference was taken for its end, where its share rounds
/// to that.
bool end_of_long_edge(const munk::Port& port, const Deviation& deviation);
/// A normal without length: both ends of the edge that is nearest are one in doubles.
bool normal_without_length(const munk::Port& port, const Deviation& deviation);
/// No answer: an edge that EPA was to expand had no length, and Chipmunk ends the program there.
bool aborts_on_equal_corners(const LostAnswer& lost);
/// What Chipmunk and its ports declare.
const Declaration& as_chipmunk();
/// B's vertices minus A's, in world directions: the corners, and more, of what GJK walks on.
std::vector<Vector2<double>> differences_of_vertices(const PairCase& pair);

/// What Chipmunk is known for; its ports have most of these causes.
inline constexpr LedgerRow kRowsOfMunk[] = {
    {"normal-of-world-vertices", normal_of_rounded_vertices},
    {"corner-on-corner", corner_on_corner},
    {"collinear-apart", collinear_and_apart},
    {"swapped-distance", sign_of_swapped_distance},
    {"polygon-radius-sign", sign_of_polygon_radius},
    {"direction-of-roundings", direction_to_place_on_segment},
    {"round-corner-on-corner", normal_across_corner_on_corner},
    {"round-collinear", normal_across_collinear},
    {"depth-by-crossing", depth_by_crossing},
    {"direction-between-corners", direction_between_corners},
    {"segment-normal-not-unit", segment_normal_not_unit},
    {"epa-of-equal-corners", nullptr, aborts_on_equal_corners},
};

/// What a replay of all steps of a port tells: these rows stand after all others.
template <const munk::Port& kPort>
inline constexpr LedgerRow kReplayedRowsOf[] = {
    {"wrong-support-edge", [](const Deviation& d) { return wrong_support_edge(kPort, d); }},
    {"normal-without-length", [](const Deviation& d) { return normal_without_length(kPort, d); }},
    {"rounded-in-the-world", [](const Deviation& d) { return rounded_in_the_world(kPort, d); }},
    {"end-of-long-edge", [](const Deviation& d) { return end_of_long_edge(kPort, d); }},
};

}  // namespace manifuzz
