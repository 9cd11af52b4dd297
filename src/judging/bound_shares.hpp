#pragma once

#include "judging/admissible.hpp"
#include "judging/compare.hpp"
#include "judging/manifold_error.hpp"

namespace manifuzz {

// How much of its bounds the error of a right answer takes: shares, 1 being as far off as a right
// collider may be, and 0 where nothing measures it.

/// The shares of its bounds that a right manifold takes, against the right one of whose bounds it
/// takes the least.
ManifoldError clip_shares(const Manifold<double>& manifold, const Admissible& right);

/// The shares that a right answer takes which the penetration curve judges: of its depth, and of
/// its normal, or of the depth along that. A collider that declares a tolerance or a tie bias has
/// none: its answers may be off by more than bounds; nor has a depth that is right only where
/// corners may have passed each other.
ManifoldError curve_shares(const exact::Truth& truth, const ColliderAnswer& given);

}  // namespace manifuzz
