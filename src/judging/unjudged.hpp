#pragma once

#include <optional>

#include "judging/bucket.hpp"
#include "judging/compare.hpp"

namespace manifuzz {

// What needs no judging of manifolds: answers that are lost or nonsense, and cases of which floats
// cannot say more.

/// A verdict that needs no judging of manifolds, if it is one.
std::optional<Bucket> without_judging(const exact::Truth& truth, const ColliderAnswer& subject,
                                      const ColliderAnswer& oracle);

/// Whether floats cannot say more of answers that are within bound than that they are: the bound of
/// either collider, or the tolerance that it declares, exceeds a set share of the size.
bool hides_all(const exact::Truth& truth, const ColliderAnswer& subject,
               const ColliderAnswer& oracle);

}  // namespace manifuzz
