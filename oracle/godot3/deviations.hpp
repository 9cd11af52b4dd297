#pragma once

#include "judging/ledger.hpp"

namespace manifuzz {

// What the ledger's entries on Godot 3.2 look for: the engine's operations are repeated in its own
// scalar and order, and give the answer; with the named fault mended they give a right one.

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
