#pragma once

#include "judging/ledger.hpp"

namespace manifuzz::ledger_of {

// Faults of engines that collide circles as Box2D 2.4 does; an epsilon is a world length.

/// A circle whose centre is nearer than epsilon to another's or to an edge's end: the normal is the
/// world's x axis, from the first shape of both.
bool is_axis_within(const Deviation& deviation, double epsilon);
/// A circle whose centre is nearer than epsilon to a polygon: the normal is a face's, beyond its
/// corner too.
bool is_face_within(const Deviation& deviation, double epsilon);
/// A circle whose centre is in front of a polygon: two faces tie, and one is kept although the
/// centre is beyond its end and another face is nearer. The normal comes from that end, or there is
/// no contact where the end is out of reach.
bool is_end_of_tied_face(const Deviation& deviation);

}  // namespace manifuzz::ledger_of
