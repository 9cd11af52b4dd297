#pragma once

#include <cmath>

#include "geometry/vector.hpp"

namespace manifuzz {

/// How far |cos^2 + sin^2 - 1| of a valid rotation may be from zero.
inline constexpr double kRotationTolerance = 1e-5;

/// A frame in the plane: a local point v lies at R v + position, R = [[cos, -sin], [sin, cos]].
template <class Scalar>
struct Pose {
  Vector2<Scalar> position{0, 0};  ///< of the frame's origin
  Vector2<Scalar> rotation{1, 0};  ///< (cos, sin), of unit length within kRotationTolerance

  friend bool operator==(const Pose&, const Pose&) = default;
};

/// A product rounded to the scalar, never part of a fused operation: g++ 12 fuses the products of
/// rotations that it vectorises (vfmaddsub), in spite of -ffp-contract=off.
template <class Scalar>
Scalar rounded_product(Scalar x, Scalar y) {
  Scalar product = x * y;
#if defined(__FMA__) && defined(__GNUC__) && !defined(__clang__)
  asm("" : "+x"(product));
#endif
  return product;
}

/// R v: `v` turned counter-clockwise, and as many times as long as the rotation is. Off by up
/// to 2.5 roundoffs of |v|.
template <class Scalar>
Vector2<Scalar> rotate(const Vector2<Scalar>& rotation, const Vector2<Scalar>& v) {
  return {rounded_product(rotation.x(), v.x()) - rounded_product(rotation.y(), v.y()),
          rounded_product(rotation.y(), v.x()) + rounded_product(rotation.x(), v.y())};
}

/// R^T v: the inverse of `rotate`, up to the factor cos^2 + sin^2.
template <class Scalar>
Vector2<Scalar> rotate_back(const Vector2<Scalar>& rotation, const Vector2<Scalar>& v) {
  return {rounded_product(rotation.x(), v.x()) + rounded_product(rotation.y(), v.y()),
          rounded_product(rotation.x(), v.y()) - rounded_product(rotation.y(), v.x())};
}

/// R^-1 v: the transpose over cos^2 + sin^2, the inverse of `rotate` to within roundings.
template <class Scalar>
Vector2<Scalar> rotate_inverse(const Vector2<Scalar>& rotation, const Vector2<Scalar>& v) {
  return rotate_back(rotation, v) / rotation.dot(rotation);
}

/// R v + position: a local point, placed.
template <class Scalar>
Vector2<Scalar> transform(const Pose<Scalar>& pose, const Vector2<Scalar>& v) {
  return rotate(pose.rotation, v) + pose.position;
}

/// B's pose in A's frame, of both poses in the world. Subtracting the positions first keeps the
/// distance from the origin out of everything that follows. Rotations are taken to be unit: the
/// position is as many times as long as A's, and the rotation as A's times B's.
template <class Scalar>
Pose<Scalar> relative_pose(const Pose<Scalar>& a, const Pose<Scalar>& b) {
  return {rotate_back<Scalar>(a.rotation, b.position - a.position),
          rotate_back(a.rotation, b.rotation)};
}

/// Whether |cos^2 + sin^2 - 1| is at most kRotationTolerance.
template <class Scalar>
bool is_unit_rotation(const Vector2<Scalar>& rotation) {
  const double c = static_cast<double>(rotation.x());
  const double s = static_cast<double>(rotation.y());
  return std::abs(c * c + s * s - 1.0) <= kRotationTolerance;
}

}  // namespace manifuzz
