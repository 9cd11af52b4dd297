#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Core>

namespace manifuzz {

/// A point or a direction of the plane: x to the right, y up, angles counter-clockwise. Unaligned,
/// so that it may live in any container.
template <class Scalar>
using Vector2 = Eigen::Matrix<Scalar, 2, 1, Eigen::DontAlign>;

/// z of a x b, an area: positive where b points counter-clockwise of a.
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

/// v over its length, within two roundoffs: the quotients' own direction and one last rounding. The
/// length's error is taken out by what 1 - |n|^2 leaves, which is computed exactly but for its last
/// sum. Not a number where v is zero, or has a part that is infinite or no number.
inline Vector2<double> unit_direction(const Vector2<double>& v) {
  const double squared = v.dot(v);
  if (!(squared > 0x1p-900 && squared < 0x1p900)) {  // or else the squares lose digits
    const double larger = v.cwiseAbs().maxCoeff();
    if (!(larger > 0) || !std::isfinite(v.x()) || !std::isfinite(v.y())) {
      return Vector2<double>::Constant(std::numeric_limits<double>::quiet_NaN());
    }
    const int exponent = std::ilogb(larger);
    return unit_direction({std::ldexp(v.x(), -exponent), std::ldexp(v.y(), -exponent)});
  }
  const Vector2<double> n = v / std::sqrt(squared);
  const double xx = n.x() * n.x();
  const double yy = n.y() * n.y();
  const double dropped = std::fma(n.x(), n.x(), -xx) + std::fma(n.y(), n.y(), -yy);
  const double residue = ((1 - std::max(xx, yy)) - std::min(xx, yy)) - dropped;
  return n + n * (residue / 2);
}

/// The unit direction rounded to floats, for a difference of floats whose square neither over- nor
/// underflows. The quotients alone are off by up to 3 roundoffs, and by up to 5 from what
/// `unit_direction` makes of them: that counts only next to where rounding to float turns over.
inline Vector2<float> unit_direction_of_floats(const Vector2<double>& v) {
  constexpr double off = 0x1p-50;  // 8 roundoffs
  const Vector2<double> n = v / std::sqrt(v.dot(v));
  const Vector2<float> rounded = (n * (1 - off)).cast<float>();
  if (rounded == (n * (1 + off)).cast<float>()) return rounded;
  return unit_direction(v).cast<float>();
}

}  // namespace manifuzz
