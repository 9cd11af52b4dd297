#pragma once

#include "exact/curve.hpp"

namespace manifuzz {

/// A place or a direction in the world, in pairs of doubles: for what is compared no more finely
/// than with a bound.
using WorldPlace = exact::Point<exact::DoubleDouble>;

/// A direction of any length but 0, unit.
inline WorldPlace unit_of(const WorldPlace& v) {
  const exact::DoubleDouble length = sqrt(dot(v, v));
  return {v.x / length, v.y / length};
}

/// A normal of A's frame in the world, unit.
inline WorldPlace in_world(const exact::StoredPair& pair, const Vector2<double>& normal) {
  return unit_of(turned(pair.a, exact::widen<exact::DoubleDouble>(normal)));
}

}  // namespace manifuzz
