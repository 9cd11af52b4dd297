#pragma once

#include "oracle/dyn4j/shapes.hpp"

namespace manifuzz::as_dyn4j {

/// How a detector ended.
enum class End {
  apart,       ///< it found them apart
  circles,     ///< CircleDetector
  axes,        ///< Sat, after all axes
  epsilon,     ///< Epa, within its distance epsilon
  iterations,  ///< Epa, after 100
};

/// Penetration, and how it was found.
struct Found {
  bool touches = false;
  Vector2<double> normal{0, 0};  ///< from A to B, in the world
  double depth = 0;
  End end = End::apart;
};

/// What Sat.detect finds along each axis, the signs by the centres; none where they are apart.
std::vector<Found> overlaps_along_axes(const Placed& a, const Placed& b);
/// Sat.detect.
Found by_axes(const Placed& a, const Placed& b);
/// Gjk.detect with its Epa. In checkSimplex a direction is taken for 0 where its square, of the
/// sixth power of a length, is not above Epsilon.E, or so much.
Found by_gjk(const Placed& a, const Placed& b, double square_of_zero = kEpsilon);

/// ClippingManifoldSolver.getManifold, with some faults mended.
replayed::Contact clipped_by_dyn4j(const Found& found, const Placed& a, const Placed& b,
                                   unsigned mended);

}  // namespace manifuzz::as_dyn4j
