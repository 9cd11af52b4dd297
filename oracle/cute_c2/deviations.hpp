#pragma once

#include "judging/ledger.hpp"

namespace manifuzz {

// What the ledger's entries on cute_c2 look for: the engine's operations are repeated in its own
// scalar and order, and give the answer; with the named fault mended they give a right one.

/// What cute_c2 1.08 is at fault with.
enum class FaultOfCute : unsigned {
  placed_vertices = 1,  ///< a face's normal is that of its placed ends, in float
  bias = 2,             ///< B's face clips though A's is farther
  open_planes = 4,      ///< an end on a side plane is outside
  two_frames = 8,       ///< a capsule's ends in the polygon's frame clip an edge in the world
  on_core = 16,         ///< a capsule's points are on its core
  one_point = 32,       ///< one point at most where cores are apart
  nearest_places = 64,  ///< the normal is the direction between the nearest places of c2GJK
  inside = 128          ///< cores at no distance: A's left side, and the sum of the radii
};
/// One of these.
template <FaultOfCute kFault>
bool fault_of_cute(const Deviation& deviation);
/// No contact of polygons: of features that tie in float one is kept that misses.
bool tied_features_in_cute(const Deviation& deviation);

}  // namespace manifuzz
