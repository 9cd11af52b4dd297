#pragma once

#include <array>
#include <vector>

#include "geometry/pair_case.hpp"

namespace manifuzz::ledger_of {

// Bullet in its own floats, operation by operation, so that what it answers can be said of any
// case: btVector3, btTransform and btConvexHullShape, of what oracle/bullet asks it.

/// A vector of space; Bullet sums from x to z.
using Space = Eigen::Matrix<float, 3, 1, Eigen::DontAlign>;

inline float dot(const Space& a, const Space& b) {
  return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

inline float squared(const Space& v) {
  return dot(v, v);
}

inline Space cross(const Space& a, const Space& b) {
  return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
          a.x() * b.y() - a.y() * b.x()};
}

/// v / length: btVector3 multiplies by the reciprocal.
Space over(const Space& v, float length);

/// btMatrix3x3, by rows.
using Basis = std::array<Space, 3>;

/// v * basis.
Space times(const Space& v, const Basis& basis);
Basis times(const Basis& a, const Basis& b);
Basis transposed(const Basis& basis);

/// btTransform: where a hull is.
struct BulletPlace {
  Basis basis{Space(1, 0, 0), Space(0, 1, 0), Space(0, 0, 1)};
  Space origin{0, 0, 0};

  Space to_world(const Space& local) const;
  /// A direction of the world in the hull's frame.
  Space to_local(const Space& direction) const { return times(direction, basis); }
};

/// btConvexHullShape: corners and a margin.
struct BulletHull {
  std::vector<Space> corners;
  float margin = 0;

  /// localGetSupportVertexWithoutMargin.
  const Space& farthest(const Space& along) const;
  /// Whether maxDot finds one.
  bool has_farthest(const Space& along) const;
  /// localGetSupportVertex: by the margin farther.
  Space farthest_of_round(const Space& along) const;
};

/// A pair as the adapters give it: prisms, or flat hulls.
struct BulletPair {
  BulletHull a, b;
  BulletPlace place_a, place_b;
  bool is_flat = false;
};

BulletPair prisms_of(const PairCase& pair);
BulletPair flat_hulls_of(const PairCase& pair);

/// getAngularMotionDisc.
float disc_of(const BulletHull& hull);

/// gContactBreakingThreshold, a share of getAngularMotionDisc.
inline constexpr float kRelativeBreaking = 0.02F;
/// btCollisionDispatcher::getNewManifold's threshold, up to which points are kept.
float breaking_threshold(const BulletPair& pair);

/// The square of how far apart they are looked for, m_maximumDistanceSquared: of flat hulls their
/// margins and btConvex2dConvex2dAlgorithm's breaking threshold, of prisms BT_LARGE_FLOAT.
float farthest_square_of(const BulletPair& pair);

}  // namespace manifuzz::ledger_of
