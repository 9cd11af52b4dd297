#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

#include "geometry/pose.hpp"

namespace manifuzz {

/// Polygons, poses and manifolds.

/// One of the two polygons of a pair.
enum class Side : unsigned char { a, b };

/// A of B, B of A.
constexpr Side other(Side side) {
  return side == Side::a ? Side::b : Side::a;
}

/// A corner or a face of a polygon; face i runs from vertex i to vertex i + 1.
struct Feature {
  /// Which of the two.
  enum class Kind : unsigned char { vertex, face };
  Kind kind = Kind::vertex;  ///< which of the two
  unsigned char index = 0;   ///< of the vertex or face, from 0

  friend bool operator==(const Feature&, const Feature&) = default;
};

/// What makes a contact point: A's feature and B's. An unclipped end of the incident edge is the
/// reference face and an incident vertex; a crossing is a reference vertex and the incident face.
struct FeaturePair {
  Feature a;  ///< of A
  Feature b;  ///< of B

  friend bool operator==(const FeaturePair&, const FeaturePair&) = default;
};

/// A point of a manifold.
template <class Scalar>
struct ContactPoint {
  Vector2<Scalar> position{0, 0};  ///< on the incident edge, or round surface, in A's frame
  Scalar depth = 0;                ///< total radius - separation, a world length, >= 0
  FeaturePair features;            ///< what makes it, to know it again by

  friend bool operator==(const ContactPoint&, const ContactPoint&) = default;
};

/// How two polygons touch: 0, 1 or 2 contact points. This is the contract of every collider.
///
/// Frame: everything is in A's frame, so distance from the origin costs nothing; `to_world` maps.
/// Normal: unit, the reference face's, turned to point from A to B.
/// Points: the ends of the incident edge after clipping to the reference face's slab, kept where
/// the separation is at most the total radius; ordered along the reference face's direction, so
/// that equal manifolds compare equal. Of round pairs the points are on the incident shape's
/// surface: a radius along the normal from its core. Lengths are world lengths: a rotation (cos,
/// sin) that is not quite unit scales A's frame, and `depth` is measured outside it.
template <class Scalar>
struct Manifold {
  int count = 0;                               ///< of points: 0, 1 or 2
  Side reference = Side::a;                    ///< whose face it is that clips
  Vector2<Scalar> normal{0, 0};                ///< unit, from A to B, in A's frame
  std::array<ContactPoint<Scalar>, 2> points;  ///< `count` of them
};

/// When two round shapes that touch along edges get a second point: where both edges' normals are
/// within an angle of the contact's, given by its cosine. The article says of a capsule that it
/// gives an edge, or an end, and not by which angle: at 0, which is the default, edges are always
/// clipped, and what the clip keeps decides; above 1, there is never a second point.
struct SecondPoint {
  double least_cosine = 0;  ///< of the angle between an edge's normal and the contact's

  /// One point at most.
  static constexpr SecondPoint never() { return {2}; }
  /// Where edges are within an angle in radians, from 0 to a quarter turn.
  static SecondPoint within(double angle) { return {std::cos(angle)}; }

  friend bool operator==(const SecondPoint&, const SecondPoint&) = default;
};

/// Equal where it counts: manifolds without points are all equal.
template <class Scalar>
bool operator==(const Manifold<Scalar>& m, const Manifold<Scalar>& n) {
  if (m.count != n.count) return false;
  if (m.count == 0) return true;
  return m.reference == n.reference && m.normal == n.normal && m.points[0] == n.points[0] &&
         (m.count < 2 || m.points[1] == n.points[1]);
}

/// Puts two points in the order of the contract, along the reference face's direction: its normal
/// turned by a quarter counter-clockwise, whichever polygon's it is.
template <class Scalar>
void order_points(Manifold<Scalar>& manifold) {
  if (manifold.count < 2) return;
  const Vector2<Scalar> from_a = counter_clockwise_quarter(manifold.normal);
  const Vector2<Scalar> along = manifold.reference == Side::a ? from_a : Vector2<Scalar>(-from_a);
  if (along.dot(manifold.points[1].position - manifold.points[0].position) < 0) {
    std::swap(manifold.points[0], manifold.points[1]);
  }
}

/// A copy of the manifold in another scalar, each figure rounded once: the normal is as nearly unit
/// as its rounded coordinates are.
template <class To, class From>
Manifold<To> manifold_cast(const Manifold<From>& from) {
  Manifold<To> to;
  to.count = from.count;
  to.reference = from.reference;
  to.normal = from.normal.template cast<To>();
  for (int i = 0; i < from.count; ++i) {
    to.points[i] = {from.points[i].position.template cast<To>(),
                    static_cast<To>(from.points[i].depth), from.points[i].features};
  }
  return to;
}

/// A world point in the frame at `pose`: R^-1 (x - p).
inline Vector2<double> to_local(const Pose<float>& pose, const Vector2<double>& world) {
  return rotate_inverse<double>(pose.rotation.cast<double>(), world - pose.position.cast<double>());
}

/// Equal to the last bit: 0 and -0 differ, a NaN is what it is.
inline bool same_bits(float x, float y) {
  return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y);
}

inline bool same_bits(const Vector2<float>& v, const Vector2<float>& w) {
  return same_bits(v.x(), w.x()) && same_bits(v.y(), w.y());
}

inline bool same_bits(const Pose<float>& p, const Pose<float>& q) {
  return same_bits(p.position, q.position) && same_bits(p.rotation, q.rotation);
}

/// Whether two manifolds with points have the same bits.
inline bool same_bits(const Manifold<float>& m, const Manifold<float>& n) {
  if (m.count != n.count || m.reference != n.reference || !same_bits(m.normal, n.normal)) {
    return false;
  }
  for (int i = 0; i < m.count; ++i) {
    const ContactPoint<float>& p = m.points[i];
    const ContactPoint<float>& q = n.points[i];
    if (!same_bits(p.position, q.position) || !same_bits(p.depth, q.depth) ||
        !(p.features == q.features)) {
      return false;
    }
  }
  return true;
}

}  // namespace manifuzz
