#pragma once

#include "judging/ledger.hpp"

namespace manifuzz::ledger_of {

// Faults of engines that are Box2D 2.4 in doubles, each with an epsilon of its own, a world length.

/// A circle whose centre is nearer than epsilon to another's or to an edge's end: the normal is the
/// world's x axis, from the first shape of both.
bool is_axis_within(const Deviation& deviation, double epsilon);
/// A circle whose centre is nearer than epsilon to a polygon: the normal is a face's, beyond its
/// corner too.
bool is_face_within(const Deviation& deviation, double epsilon);

}  // namespace manifuzz::ledger_of
