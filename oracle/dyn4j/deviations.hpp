#pragma once

#include "judging/ledger.hpp"

namespace manifuzz {

// What the ledger's entries on dyn4j look for, whose Sat or Gjk finds a normal and a depth: the
// engine's operations are repeated in its own scalar and order, and give the answer; with the named
// fault mended they give a right one.

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
/// Gjk: a direction of short edges is taken for 0 though the shapes are apart: Epa then finds the
/// gap between them, as a depth below 0.
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
/// One of these faults, after Sat.
template <FaultOfDyn4j kFault>
bool after_sat_of_dyn4j(const Deviation& deviation);
/// One of these faults, after Gjk.
template <FaultOfDyn4j kFault>
bool after_gjk_of_dyn4j(const Deviation& deviation);

}  // namespace manifuzz
