#pragma once

#include "judging/ledger.hpp"

namespace manifuzz {

// What the ledger's entries on matter-js look for: its operations are repeated, and give the
// answer.

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
/// With the right edges too few points, or too near each other: their ends that are inside the
/// other body are given, and no place where an edge is cut.
bool vertices_inside_alone_by_matter(const Deviation& deviation);

}  // namespace manifuzz
