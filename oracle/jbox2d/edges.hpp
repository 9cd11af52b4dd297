#pragma once

#include "judging/ledger.hpp"

namespace manifuzz {

/// What EPCollider is at fault with.
enum class FaultOfJbox2dEdge : unsigned {
  radius = 1,      ///< it takes 0.02 for the sum of the radii
  hysteresis = 2,  ///< the edge's face is kept though one of the polygon's is farther
  slab = 4,        ///< the reference face's side planes leave out the radii
  front = 8,       ///< of the edge's sides, the one towards the polygon's centroid alone is tried
  corners = 16     ///< corners apart from each other are clipped along a face's normal
};

/// Whether EPCollider's operations, repeated in its own scalar and order, give the answer, and a
/// right one with this fault mended.
bool is_edge_at_fault(const Deviation& deviation, FaultOfJbox2dEdge fault);

}  // namespace manifuzz
