#pragma once

#include "collider/sequence_collider.hpp"
#include "exact/fine_point.hpp"

namespace manifuzz {

// Where anchors and normals of kept points are in a frame, to well past double: what is compared
// with a bound is rounded once.

/// Where an anchor of a side is in the world, seen from A's position.
exact::FinePoint placed_anchor(const PairCase& pair, Side side, const Vector2<double>& anchor);

/// B's anchor in A's frame.
Vector2<double> anchor_b_in_a(const PairCase& pair, const KeptPoint& point);

/// How the anchors of a point stand to each other, as seen along a normal of the world: lengths of
/// the world.
struct AnchorsNow {
  double depth = 0;  ///< how far A's is beyond B's along the normal
  double drift = 0;  ///< how far they are from each other across it
};
AnchorsNow anchors_now(const PairCase& pair, const KeptPoint& point, const Vector2<double>& normal);

/// Where an anchor of a side is along a direction.
double place_along(const PairCase& pair, Side side, const Vector2<double>& anchor,
                   const Vector2<double>& direction);

/// A normal of the world, carried from one frame to another by a side; unit.
Vector2<double> carried(const PairCase& then, const PairCase& now, Side by,
                        const Vector2<double>& normal);

/// How far a normal is from an earlier one as this body carries it; from the nearest direction
/// between those as A carries it and as B does where it travels with none: the length of the
/// difference of two unit vectors.
double off_carried(const PairCase& then, const PairCase& now, TravelsWith by,
                   const Vector2<double>& normal_then, const Vector2<double>& normal_now);

/// The angle by which B has turned against A, in radians.
double turned_since(const PairCase& then, const PairCase& now);

}  // namespace manifuzz
