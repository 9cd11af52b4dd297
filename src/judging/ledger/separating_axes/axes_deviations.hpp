#pragma once

#include "judging/compare.hpp"

namespace manifuzz {

// What the ledger's entries on engines of separating axes, and on what those are detected with
// besides, look for: the engine's operations are repeated in its own scalar and order, and give the
// answer; with the named fault mended they give a right one, and with no fewer faults mended.

/// SAT.js 0.9.0: of polygons that just touch the overlap is 0, and the axis is not turned about.
bool axis_of_exact_touch_in_sat(const Deviation& deviation);
/// SAT.js 0.9.0: the centres of two circles are at one place, and the normal has no length.
bool no_normal_of_one_centre_in_sat(const Deviation& deviation);

/// jbox2d 2.2.1.1: of a polygon's faces a local maximum of the separation is kept, to which the
/// direction between the centroids has led.
bool local_maximum_in_jbox2d(const Deviation& deviation);

/// What EPCollider of jbox2d 2.2.1.1 is at fault with.
enum class FaultOfJbox2dEdge : unsigned {
  radius = 1,      ///< it takes 0.02 for the sum of the radii
  hysteresis = 2,  ///< the edge's face is kept though one of the polygon's is farther
  slab = 4,        ///< the reference face's side planes leave out the radii
  front = 8,       ///< of the edge's sides, the one towards the polygon's centroid alone is tried
  corners = 16     ///< corners apart from each other are clipped along a face's normal
};
/// One of these.
template <FaultOfJbox2dEdge kFault>
bool fault_of_jbox2d_edge(const Deviation& deviation);

// dyn4j 6.0.0, whose Sat or Gjk finds a normal and a depth.

/// Sat: the least overlap is on the other side than the centres, which decide for the sign.
bool sign_by_centres_in_dyn4j(const Deviation& deviation);
/// Sat: of axes whose overlaps are equal within rounding it takes the first.
bool first_of_equal_axes_in_dyn4j(const Deviation& deviation);
/// CircleDetector: a difference of centres that is not longer than Epsilon.E is not normalised.
bool no_normal_of_one_centre_in_dyn4j(const Deviation& deviation);
/// Epa: it ends where the next point is nearer than the root of Epsilon.E.
bool epa_within_epsilon_in_dyn4j(const Deviation& deviation);
/// Gjk: a direction of short edges is taken for 0, its square being compared with Epsilon.E: the
/// edge's left side is searched, wherever the origin lies.
bool gjk_direction_within_epsilon_in_dyn4j(const Deviation& deviation);
/// The same of shapes that are apart: Epa then finds the gap between them, as a depth below 0.
bool gjk_depth_below_0_in_dyn4j(const LostAnswer& lost);
/// Epa: a point is found twice, and the edge between both has no length and no normal.
bool epa_edge_of_no_length_in_dyn4j(const Deviation& deviation);
/// Epa: it ends after 100 iterations.
bool epa_after_iterations_in_dyn4j(const Deviation& deviation);
/// Gjk: it finds them apart.
bool gjk_apart_in_dyn4j(const Deviation& deviation);

/// ClippingManifoldSolver, after Sat and after Gjk, that found the depth: of edges that tie it
/// takes one that misses the other's slab.
bool edges_tie_after_sat_of_dyn4j(const Deviation& deviation);
bool edges_tie_after_gjk_of_dyn4j(const Deviation& deviation);

/// What ClippingManifoldSolver, and the features that it asks for, are at fault with.
enum class FaultOfDyn4j : unsigned {
  longer_capsule = 2,    ///< the edge of a capsule is longer than its core
  normal_of_edge = 4,    ///< the normal is the reference edge's, and depths are along it
  placed_vertices = 8,   ///< the reference edge's direction is that of its placed ends
  longer_edges = 16,     ///< the edge clips whose product with the normal is least
  any_angle = 32,        ///< segments and polygons have an edge, whatever its angle
  neighbour_by_dot = 64  ///< of edges beside each other, dots of unit vectors decide
};
/// One of these, after Sat.
template <FaultOfDyn4j kFault>
bool after_sat_of_dyn4j(const Deviation& deviation);
/// The same after Gjk.
template <FaultOfDyn4j kFault>
bool after_gjk_of_dyn4j(const Deviation& deviation);

/// What cute_c2 1.08 is at fault with.
enum class FaultOfCute : unsigned {
  placed_vertices = 1,  ///< a face's normal is that of its placed ends, in float
  bias = 2,             ///< B's face clips though A's is farther
  open_planes = 4,      ///< an end on a side plane is outside
  two_frames = 8,       ///< a capsule's ends in the polygon's frame clip an edge in the world
  on_core = 16,         ///< a capsule's points are on its core
  one_point = 32,       ///< one point at most where cores are apart
  nearest_places = 64,  ///< the normal is the direction between the nearest places of c2GJK
  inside = 128          ///< cores at no distance: A's left side, and the sum of the radii
};
/// One of these.
template <FaultOfCute kFault>
bool fault_of_cute(const Deviation& deviation);
/// No contact of polygons: of features that tie in float one is kept that misses.
bool tied_features_in_cute(const Deviation& deviation);

/// What Godot 3.2 is at fault with.
enum class FaultOfGodot : unsigned {
  short_difference = 1,  ///< normal and depth are those of the difference of rounded points
  first_ends = 2,        ///< of two edges, places are on the planes through their first ends
  first_edge = 4,        ///< of a polygon's edges within 0.36 degrees the first is met
  segment_length = 8,    ///< a segment's normal is as long as the segment
  tested_axis = 16,      ///< the axis is between two rounded places, or one of several that tie
  flat_capsule = 32,     ///< a capsule within 0.0012 degrees has a side, with its normal
  uncapped_foot = 64,    ///< a point meets an edge's line where it is nearest, beyond its ends too
  rounded_ends = 128,    ///< an edge's line is that of its ends as rounded in the world
  short_edge = 256,      ///< an edge shorter than 1e-10 is its first end
  start_values = 512,    ///< supports below -1e10 and overlaps above 1e15 are not found
  squared_length = 1024  ///< the square of a length overflows or underflows
};
/// One of these.
template <FaultOfGodot kFault>
bool fault_of_godot(const Deviation& deviation);
/// A crash: no vertex of a polygon is farther than where the search for the farthest begins, so
/// that the count of supports is what the stack held.
bool no_support_found_by_godot(const LostAnswer& lost);

}  // namespace manifuzz
