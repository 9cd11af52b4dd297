#pragma once

#include <cmath>
#include <type_traits>

#include "geometry/pair_case.hpp"

namespace manifuzz::clipping {

/// A pair as the algorithm takes it: polygons of one length unit, poses of unit rotation.
template <class Scalar>
struct PlacedPair {
  ConvexPolygon<Scalar> a;
  ConvexPolygon<Scalar> b;
  Pose<Scalar> pose_a;
  Pose<Scalar> pose_b;
  Scalar local_per_world = 1;  ///< A's local length of one world length
};

/// The pair as it stands: its rotations are taken to be unit.
inline PlacedPair<float> placed_pair_as_given(const PairCase& pair) {
  return {pair.a.polygon, pair.b.polygon, pair.a.pose, pair.b.pose, 1};
}

/// A stored rotation (cos, sin) of length k turns by its direction and scales by k: the polygon is
/// scaled, and the rest is rigid.
inline PlacedPair<double> placed_pair_scaled(const PairCase& pair) {
  PlacedPair<double> placed;
  const auto place = [](const Body& body, ConvexPolygon<double>& polygon, Pose<double>& pose) {
    const Vector2<double> rotation = body.pose.rotation.cast<double>();
    const double k = std::sqrt(rotation.dot(rotation));
    polygon = polygon_cast<double>(body.polygon);
    for (int i = 0; i < polygon.count; ++i) polygon.vertices[i] *= k;
    pose = {body.pose.position.cast<double>(), unit_direction(rotation)};
    return k;
  };
  placed.local_per_world = 1 / place(pair.a, placed.a, placed.pose_a);
  place(pair.b, placed.b, placed.pose_b);
  return placed;
}

/// The pair for a collider of this scalar, float or double.
template <class Scalar>
PlacedPair<Scalar> placed_pair(const PairCase& pair) {
  if constexpr (std::is_same_v<Scalar, float>) {
    return placed_pair_as_given(pair);
  } else {
    return placed_pair_scaled(pair);
  }
}

}  // namespace manifuzz::clipping
