#pragma once

#include "geometry/vector.hpp"

namespace manifuzz {

/// The exact sign of the area of triangle abc: 1 counter-clockwise, -1 clockwise, 0 on one line.
/// After Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
/// Predicates" (1997): a filter first, then an expansion. Exact for every finite float; for doubles
/// while no product of two coordinates over- or underflows.
int orientation(const Vector2<double>& a, const Vector2<double>& b, const Vector2<double>& c);

template <class Scalar>
int orientation(const Vector2<Scalar>& a, const Vector2<Scalar>& b, const Vector2<Scalar>& c) {
  return orientation(Vector2<double>(a.template cast<double>()),
                     Vector2<double>(b.template cast<double>()),
                     Vector2<double>(c.template cast<double>()));
}

}  // namespace manifuzz
