#pragma once

#include "judging/ledger.hpp"

namespace manifuzz {

// What the ledger's entries on nape look for.

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
