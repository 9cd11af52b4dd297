#pragma once

#include "judging/ledger.hpp"

namespace manifuzz {

// What the ledger's entries on btConvexConvexAlgorithm with turned shapes look for, repeated in its
// own floats: the answer is what the repeated one gives, and without the named part of it, and none
// less, it would be right.

/// A turned query's point took the place of a right one nearby.
bool point_replaced_by_turned(const Deviation& deviation);
/// refreshContactPoints moved, measured or left out a point.
bool changed_by_refresh(const Deviation& deviation);
/// The deepest point is a turned query's: its normal, and what was measured along it.
bool normal_of_turned_query(const Deviation& deviation);
/// The deepest is the first query's, and the other a turned query's.
bool point_of_turned_query(const Deviation& deviation);

/// The first query's normal is upright, by a fault of that query's that the entries on bullet-epa
/// name, and so the shapes are turned out of the plane.
bool turned_out_of_plane(const Deviation& deviation);

/// The first query's answer, without turned ones, is wrong too, by what a predicate on bullet-epa
/// looks for.
bool is_of_first_query(const Deviation& deviation, bool (*explains)(const Deviation&));
template <bool (*explains)(const Deviation&)>
bool of_first_query(const Deviation& deviation) {
  return is_of_first_query(deviation, explains);
}

}  // namespace manifuzz
