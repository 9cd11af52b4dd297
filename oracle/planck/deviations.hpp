#pragma once

#include "judging/ledger.hpp"

namespace manifuzz {

// What the ledger's entries on planck look for beside Box2D's own faults: each recomputes what the
// named fault makes of the case, in double, and holds the answer against that within the collider's
// bounds.

/// An edge against a polygon in planck, clipped between the very ends of the reference face.
bool planck_edge_slab_not_widened(const Deviation& deviation);
/// The same, where the face is not the one of the greatest separation: the edge's towards the
/// polygon's centroid, or whichever 0.98 times the edge's separation and 0.001 decide for.
bool planck_edge_hysteresis(const Deviation& deviation);
/// A circle whose centre is within 1e-9 of another's or of an edge's end: the normal is the world's
/// x axis.
bool axis_within_planck_epsilon(const Deviation& deviation);
/// A circle whose centre is within 1e-9 of a polygon: the normal is a face's, beyond its corner
/// too.
bool face_within_planck_epsilon(const Deviation& deviation);

}  // namespace manifuzz
