#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "exact/placed.hpp"
#include "geometry/pair_case.hpp"

// parry2d, whose operations are repeated in its order and in its scalar, so that the numbers
// are its own to the last bit: vectors as glam has them, and shapes with their support points.

namespace manifuzz::parry {

/// DEFAULT_EPSILON of math/mod.rs.
template <class Real>
inline constexpr Real kEpsilon = std::numeric_limits<Real>::epsilon();

/// gjk.rs: eps_tol, a length or the square of one.
template <class Real>
inline constexpr Real kGjkTolerance = kEpsilon<Real>* Real(10);

/// gjk.rs: _eps_rel.
template <class Real>
Real relative_tolerance() {
  return std::sqrt(kGjkTolerance<Real>);
}

/// A vector's direction and length: the first axis and 0 where it has none.
template <class Real>
struct DirectionAndLength {
  Vector2<Real> direction;
  Real length;
};

template <class Real>
Real length_of(const Vector2<Real>& v) {
  return std::sqrt(v.x() * v.x() + v.y() * v.y());
}

template <class Real>
std::optional<Vector2<Real>> try_normalize(const Vector2<Real>& v) {
  const Real reciprocal = Real(1) / length_of(v);
  if (!std::isfinite(reciprocal) || !(reciprocal > 0)) return std::nullopt;
  return Vector2<Real>(v.x() * reciprocal, v.y() * reciprocal);
}

template <class Real>
DirectionAndLength<Real> normalize_and_length(const Vector2<Real>& v) {
  const auto direction = try_normalize(v);
  if (!direction) return {{1, 0}, 0};
  return {*direction, length_of(v)};
}

/// relative_eq! of the crate approx, with its defaults.
template <class Real>
bool is_relatively_equal(Real x, Real y) {
  const Real difference = std::abs(x - y);
  return x == y || difference <= kEpsilon<Real> ||
         difference <= std::max(std::abs(x), std::abs(y)) * kEpsilon<Real>;
}

template <class Real>
Pose<Real> inverse(const Pose<Real>& pose) {
  const Vector2<Real> turn(pose.rotation.x(), -pose.rotation.y());
  return {rotate<Real>(turn, Vector2<Real>(-pose.position)), turn};
}

template <class Real>
Pose<Real> composed(const Pose<Real>& first, const Pose<Real>& second) {
  return {first.position + rotate(first.rotation, second.position),
          rotate(first.rotation, second.rotation)};
}

template <class Real>
Vector2<Real> inverse_transform(const Pose<Real>& pose, const Vector2<Real>& point) {
  return rotate_back<Real>(pose.rotation, point - pose.position);
}

/// A Ball, Segment, Capsule, ConvexPolygon or RoundShape of one, by how many corners it has and
/// whether it has a radius.
template <class Real>
struct Shape {
  std::vector<Vector2<Real>> corners{};  ///< none of a ball: it is about its origin
  std::vector<Vector2<Real>> normals{};  ///< of a polygon
  Real radius = 0;

  bool is_ball() const { return corners.empty(); }
  bool is_capsule() const { return corners.size() == 2 && radius > 0; }
  bool is_polygon() const { return corners.size() > 2; }

  /// The core's support: of equals a segment's second end, a polygon's first corner.
  const Vector2<Real>& farthest_corner(const Vector2<Real>& along) const {
    if (corners.size() == 2) {
      return corners[0].dot(along) > corners[1].dot(along) ? corners[0] : corners[1];
    }
    std::size_t best = 0;
    for (std::size_t i = 1; i < corners.size(); ++i) {
      if (corners[i].dot(along) > corners[best].dot(along)) best = i;
    }
    return corners[best];
  }

  /// The support of the core, and of its radius if that is asked for.
  Vector2<Real> support(const Vector2<Real>& along, bool is_round) const {
    if (!is_round || radius == 0) return farthest_corner(along);
    const Vector2<Real> unit = unit_of(along);
    return farthest_corner(unit) + unit * radius;
  }

  /// A capsule's is y where there is none.
  Vector2<Real> unit_of(const Vector2<Real>& along) const {
    const auto unit = try_normalize(along);
    if (unit || is_capsule()) return unit.value_or(Vector2<Real>(0, 1));
    return along * (Real(1) / length_of(along));
  }

  /// ConvexPolygon::local_support_feature: the face, the first of equals.
  std::size_t support_face(const Vector2<Real>& along) const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < normals.size(); ++i) {
      if (normals[i].dot(along) > normals[best].dot(along)) best = i;
    }
    return best;
  }
};

/// What GJK and EPA ask of two shapes: A's support points, and B's in A's frame. B may be the
/// origin of its frame.
template <class Real>
struct Operands {
  const Shape<Real>* a = nullptr;
  const Shape<Real>* b = nullptr;  ///< none: ConstantOrigin
  Pose<Real> between;              ///< B's frame in A's
  bool is_round = false;           ///< with their radii

  Vector2<Real> of_a(const Vector2<Real>& along) const { return a->support(along, is_round); }
  Vector2<Real> of_b(const Vector2<Real>& along) const {
    if (b == nullptr) return between.position;
    return transform(between, b->support(rotate_back(between.rotation, along), is_round));
  }
};

/// CsoPoint: a point of A's shape less B's.
template <class Real>
struct Corner {
  Vector2<Real> point{0, 0};
  Vector2<Real> on_a{0, 0};
  Vector2<Real> on_b{0, 0};
};

template <class Real>
Corner<Real> corner_along(const Operands<Real>& operands, const Vector2<Real>& along) {
  Corner<Real> corner;
  corner.on_a = operands.of_a(along);
  corner.on_b = operands.of_b(Vector2<Real>(-along));
  corner.point = corner.on_a - corner.on_b;
  return corner;
}

/// A shape where it stands.
template <class Real>
struct Placed {
  Shape<Real> shape;
  Pose<Real> pose;
};

/// utils/ccw_face_normal.rs; none of a face without length.
template <class Real>
std::optional<Vector2<Real>> face_normal(const Vector2<Real>& from, const Vector2<Real>& to) {
  const Vector2<Real> along = to - from;
  return try_normalize(Vector2<Real>(along.y(), -along.x()));
}

/// ConvexPolygon::from_convex_polyline: without the corners between normals nearer than the root of
/// epsilon; the normals that are left are those of the faces as they were.
template <class Real>
Shape<Real> simplified(const Shape<Real>& full) {
  if (!full.is_polygon()) return full;
  const Real most = Real(1) - std::sqrt(kEpsilon<Real>);
  Shape<Real> kept{.radius = full.radius};
  for (std::size_t i = 0; i < full.corners.size(); ++i) {
    const std::size_t before = i == 0 ? full.normals.size() - 1 : i - 1;
    if (full.normals[before].dot(full.normals[i]) > most) continue;
    kept.corners.push_back(full.corners[i]);
    kept.normals.push_back(full.normals[i]);
  }
  return kept;
}

}  // namespace manifuzz::parry
