#pragma once

#include "exact/arithmetic.hpp"
#include "exact/placed.hpp"

namespace manifuzz::exact {

/// A place or a direction in pairs of doubles: fine enough for what is compared with a bound, not
/// for exact decisions.
using FinePoint = Point<DoubleDouble>;

/// A direction of any length but 0, unit.
inline FinePoint unit_of(const FinePoint& v) {
  const DoubleDouble length = sqrt(dot(v, v));
  return {v.x / length, v.y / length};
}

/// A normal of A's frame in the world, unit.
inline FinePoint in_world(const StoredPair& pair, const Vector2<double>& normal) {
  return unit_of(turned(pair.a, widen<DoubleDouble>(normal)));
}

}  // namespace manifuzz::exact
