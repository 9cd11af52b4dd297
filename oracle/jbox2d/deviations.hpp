#pragma once

#include "judging/ledger.hpp"

namespace manifuzz {

// What the ledger's entries on jbox2d 2.2.1.1 look for beside Box2D's own faults: the engine's
// operations are repeated in its own scalar and order, and give the answer; with the named fault
// mended they give a right one.

/// jbox2d: no contact of an edge and a polygon that are farther apart than 0.02, the radii that it
/// takes for theirs.
bool edge_radius_of_settings(const Deviation& deviation);
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

}  // namespace manifuzz
