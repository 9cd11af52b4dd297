#pragma once

#include "judging/ledger.hpp"

namespace manifuzz {

// What the ledger's entries on p2 on circles look for: its operations are repeated, and give the
// answer.

/// A normal without length, and no depth: what it is made of is (0, 0).
bool zero_normal_of_p2(const Deviation& deviation);
/// A centre on a capsule's core, but for roundings: the sign of the normal is theirs, and the sign
/// with which the capsule's radius counts; at an end, the direction.
bool direction_of_roundings_of_p2(const Deviation& deviation);
/// A capsule's first end, where another place of its core is nearer.
bool first_end_of_p2(const Deviation& deviation);
/// A capsule's normal is that of its ends as floats have them in the world: off by their roundings
/// over its length.
bool edge_of_rounded_ends_in_p2(const Deviation& deviation);
/// A face's contact where a vertex is the nearest, or another face.
bool face_before_vertex_of_p2(const Deviation& deviation);
/// A vertex' contact, or none, where a face is the nearest: the circle's own point behind that face
/// is outside of the polygon.
bool vertex_before_face_of_p2(const Deviation& deviation);

}  // namespace manifuzz
