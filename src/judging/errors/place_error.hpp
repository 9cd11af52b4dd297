#pragma once

#include <span>

#include "exact/witness.hpp"
#include "geometry/manifold.hpp"

namespace manifuzz {

// How far points are from where they may be, as near as doubles say it: whether they are there is
// decided exactly elsewhere.

/// How far a place of A's frame is from the farther of both shapes, each grown by the total radius
/// with the pair's corners; a world length, 0 inside of both.
double distance_from_both(const exact::Truth& truth, const Vector2<double>& place);

/// How far a place of A's frame is from the nearest vertex of both cores, less the total radius.
double distance_from_vertices(const exact::Truth& truth, const Vector2<double>& place);

/// What a contact point says, seen along a normal.
struct WitnessClaim {
  const ContactPoint<double>& point;
  std::span<const exact::Height> heights;  ///< it lies at one of them
  double gap_least = 0;                    ///< the overlap at its place is between these two
  double gap_most = 0;
};

/// How far a contact point is from being a witness along a normal of A's frame: over all places
/// that both cores have on a line along it, the least of the greater of the distance to the place
/// and what the overlap there lies outside of what is claimed; a world length.
double witness_error(const exact::Truth& truth, const Vector2<double>& normal,
                     const WitnessClaim& claim);

}  // namespace manifuzz
