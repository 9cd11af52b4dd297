#pragma once

#include "judging/ledger.hpp"

namespace manifuzz {

// What the ledger's entries on ccdMPRPenetration look for that repeat it in its own doubles, in
// space: the answer is that of the repeated one.

/// The origin is on the segment from the difference's middle to its corner that is farthest beyond
/// it, or is that middle. The translation is to this corner, not to the face that it is on.
bool translation_to_corner_of_ray(const Deviation& deviation);
/// The last portal, through which the ray from the middle leaves, is within the tolerance of the
/// boundary: the translation is at right angles to it, and ends within it.
bool translation_to_portal(const Deviation& deviation);
/// The foot of the origin is beside the last portal, one triangle: the translation is to an edge or
/// a corner of it.
bool translation_to_edge_of_portal(const Deviation& deviation);

}  // namespace manifuzz
