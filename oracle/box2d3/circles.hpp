#pragma once

#include "judging/ledger.hpp"

namespace manifuzz {

// What the ledger's entries on Box2D 3.2's circles look for: each repeats in floats what the engine
// makes of the case, and holds the answer against that within the collider's bounds.

/// A circle whose centre is within float's epsilon of another core: the normal has no length.
bool no_normal_within_box2d3_epsilon(const Deviation& deviation);
/// A circle and a segment, a capsule or a polygon's corner: the normal is the direction to the
/// place on the core that is nearest as floats have it.
bool direction_of_rounded_place(const Deviation& deviation);
/// A circle in front of faces that tie in floats: the normal is the direction from the end of the
/// one that Box2D 3.2 keeps, though the centre is in front of another.
bool corner_of_tied_face(const Deviation& deviation);
/// A circle whose centre is in front of a face by no more than float's epsilon, and beyond its end:
/// the normal is the face's, and what would be right is the direction from that end, or no contact.
bool face_within_box2d3_epsilon(const Deviation& deviation);

}  // namespace manifuzz
