#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/convex_polygon.hpp"
#include "geometry/manifold.hpp"

namespace manifuzz {

/// A shape and where it stands in the world. Floats, the very ones that every collider gets.
struct Body {
  ConvexPolygon<float> polygon;  ///< in the body's own frame
  Pose<float> pose;              ///< in the world

  friend bool operator==(const Body&, const Body&) = default;
};

/// Two convex shapes with a pose each: the unit everything passes around.
struct PairCase {
  Body a;  ///< the manifold is in its frame
  Body b;  ///< the normal points to it

  /// The body on this side.
  const Body& operator[](Side side) const { return side == Side::a ? a : b; }
  /// The body on this side.
  Body& operator[](Side side) { return side == Side::a ? a : b; }
  friend bool operator==(const PairCase&, const PairCase&) = default;
};

/// The sum of both radii, a length: shapes touch while the separation is at most this.
inline double total_radius(const PairCase& pair) {
  return static_cast<double>(pair.a.polygon.radius) + static_cast<double>(pair.b.polygon.radius);
}

/// Whether the shapes touch as round ones do.
inline bool is_round(const PairCase& pair) {
  return are_round(pair.a.polygon, pair.b.polygon);
}

/// The smaller shape's size, a length: the yardstick of errors.
inline double size(const PairCase& pair) {
  if (is_round(pair)) return std::min(size(pair.a.polygon), size(pair.b.polygon));
  return smaller_diameter(pair.a.polygon, pair.b.polygon);
}

/// E of the error bounds, a length: the reach of both polygons plus the distance between their
/// origins.
inline double extent(const PairCase& pair) {
  const Vector2<double> apart =
      pair.b.pose.position.cast<double>() - pair.a.pose.position.cast<double>();
  return reach(pair.a.polygon) + reach(pair.b.polygon) + std::sqrt(apart.dot(apart));
}

/// A local point of A in the world, to double precision.
inline Vector2<double> to_world(const PairCase& pair, const Vector2<double>& local) {
  const Pose<double> pose{pair.a.pose.position.cast<double>(), pair.a.pose.rotation.cast<double>()};
  return transform(pose, local);
}

/// The manifold's normal in the world: from A to B, as long as the local one, hence unit.
inline Vector2<double> world_normal(const PairCase& pair, const Vector2<double>& local) {
  const Vector2<double> rotation = pair.a.pose.rotation.cast<double>();
  return rotate<double>(rotation, local) / std::sqrt(rotation.dot(rotation));
}

/// A normal of the world, from A to B, in A's frame: unit where `length` is its length.
inline Vector2<double> local_normal(const PairCase& pair, const Vector2<double>& world,
                                    double length = 1) {
  const Vector2<double> rotation = pair.a.pose.rotation.cast<double>();
  return rotate_back<double>(rotation, world) / (std::sqrt(rotation.dot(rotation)) * length);
}

}  // namespace manifuzz
