#pragma once

#include "judging/ledger.hpp"

// What the ledger's entries look for, in the judge's terms; ledger.cpp says whose deviation each is
// and where it comes from.

namespace manifuzz {

/// No contact for overlapping polygons: the bias keeps A's shallower face, whose slab misses.
bool no_contact_under_bias(const Deviation& deviation);
/// No contact for overlapping polygons: of features that tie, one is kept whose slab misses.
bool no_contact_on_tied_features(const Deviation& deviation);
/// The reference face is too short for b2Vec2::Normalize, or shorter than world coordinates
/// resolve.
bool tiny_reference_face(const Deviation& deviation);
/// The square of the reference face's length is beyond float, so that b2Vec2::Normalize divides by
/// infinity.
bool huge_reference_face(const Deviation& deviation);
/// An end of the incident edge lies so near a side plane that the product of both ends' distances
/// underflows: the crossing is not seen, and one point is left.
bool crossing_underflows(const Deviation& deviation);
/// An incident edge that misses the slab, prolonged to it: a point off the polygon, or contact
/// across a gap.
bool edge_extended_to_slab(const Deviation& deviation);
/// The incident edge, along the reference face, is too short to be clipped.
bool incident_edge_unclipped(const Deviation& deviation);
/// The normal is that of vertices that were rounded on the way: off by their roundoff over the
/// face's length.
bool normal_of_rounded_vertices(const Deviation& deviation);
/// The normal is arbitrary, or the contact missed, and a corner of A lies on a corner of B.
bool corner_on_corner(const Deviation& deviation);
/// Contact for polygons that are apart, and the origin lies on the line through two of their
/// difference's corners, beyond them.
bool collinear_and_apart(const Deviation& deviation);
/// The neighbour of the right face is clipped: their directions are nearer than a dot product can
/// tell.
bool neighbours_nearly_parallel(const Deviation& deviation);

}  // namespace manifuzz
