#pragma once

#include <cmath>
#include <vector>

#include "geometry/pair_case.hpp"

namespace manifuzz::as_cute {

// What cute_c2 makes of a case, its operations and the adapter's repeated in their order, in
// float: the numbers are the engine's to the last bit.

/// c2MulxvT.
inline Vector2<float> placed_back(const Pose<float>& by, const Vector2<float>& v) {
  return rotate_back<float>(by.rotation, v - by.position);
}

/// c2Norm.
inline Vector2<float> unit_of(const Vector2<float>& v) {
  return v * (1.0F / std::sqrt(v.dot(v)));
}

/// A c2Circle or c2Capsule, which are in the world, or a c2Poly with its c2x.
struct Shape {
  std::vector<Vector2<float>> vertices;
  std::vector<Vector2<float>> normals;
  float radius = 0;
  Pose<float> placing{};

  explicit Shape(const Body& body);

  std::size_t count() const { return vertices.size(); }
  std::size_t next(std::size_t i) const { return i + 1 == count() ? 0 : i + 1; }
  Vector2<float> vertex(std::size_t i) const { return transform(placing, vertices[i]); }
  /// c2Support.
  std::size_t support(const Vector2<float>& along) const;
};

/// Where two shapes without radii are nearest; a distance of 0 where the origin is found inside.
struct Nearest {
  Vector2<float> on_a{0, 0};
  Vector2<float> on_b{0, 0};
  float distance = 0;
  bool is_within_epsilon = false;  ///< c2GJK ended at corners nearer than epsilon
};

/// c2GJK, without radii.
Nearest nearest_by_cute(const Shape& a, const Shape& b);

}  // namespace manifuzz::as_cute
