#pragma once

#include <Eigen/Core>

namespace manifuzz {

/// A point or a direction of the plane. Unaligned, so that it may live in any container.
template <class Scalar>
using Vector2 = Eigen::Matrix<Scalar, 2, 1, Eigen::DontAlign>;

/// z of a x b: positive where b points counter-clockwise of a.
template <class Scalar>
Scalar cross(const Vector2<Scalar>& a, const Vector2<Scalar>& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// `v` turned by a quarter clockwise: along a counter-clockwise edge, the outward normal.
template <class Scalar>
Vector2<Scalar> clockwise_quarter(const Vector2<Scalar>& v) {
  return {v.y(), -v.x()};
}

/// `v` turned by a quarter counter-clockwise: along an outward normal, the face's direction.
template <class Scalar>
Vector2<Scalar> counter_clockwise_quarter(const Vector2<Scalar>& v) {
  return {-v.y(), v.x()};
}

}  // namespace manifuzz
