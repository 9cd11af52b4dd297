#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "geometry/pair_case.hpp"
#include "oracle/box2d3/faces.hpp"

// Box2D 3.2's arithmetic, in floats.

namespace manifuzz::ledger_of::box2d3 {

using Float2 = Vector2<float>;

inline constexpr float kSlop = 0.005F;                                    // B2_LINEAR_SLOP
inline constexpr float kTenth = 0.1F * kSlop;                             // 0.1f * linearSlop
inline constexpr float kSpeculative = 4.0F * kSlop;                       // B2_SPECULATIVE_DISTANCE
inline constexpr float kEpsilon = std::numeric_limits<float>::epsilon();  // FLT_EPSILON

inline Float2 lerp(const Float2& a, const Float2& b, float t) {
  return {(1.0F - t) * a.x() + t * b.x(), (1.0F - t) * a.y() + t * b.y()};
}

inline Float2 normalized(const Float2& v) {
  const float length = v.norm();
  if (length < kEpsilon) return {0, 0};
  const float inverse = 1.0F / length;
  return {inverse * v.x(), inverse * v.y()};
}

/// Both shapes in the first one's frame, from its vertex 0.
struct Placed {
  ConvexPolygon<float> first;   ///< its vertex 0 at (0, 0)
  ConvexPolygon<float> second;  ///< moved along
  Side side = Side::a;          ///< whose is the first

  float radius() const { return first.radius + second.radius; }
};

/// b2SegmentDistance of edges that are longer than its epsilon.
struct SegmentDistance : NearestShares<float> {
  Float2 closest1{0, 0};  ///< the place on the first
  Float2 closest2{0, 0};  ///< the place on the second
  Float2 between{0, 0};   ///< from the one to the other
  float square = 0;       ///< of its length
};

SegmentDistance segment_distance(const Float2& p1, const Float2& q1, const Float2& p2,
                                 const Float2& q2);

/// A point halfway between both surfaces.
struct PointOf {
  Float2 at;             ///< from the first one's vertex 0
  float separation = 0;  ///< of the surfaces
};

/// The point of a place on the incident core that is so far from the reference core along its
/// normal.
inline PointOf clipped_point(const Float2& place, const Float2& normal, float distance,
                             float of_reference, float of_incident) {
  return {place + 0.5F * (of_reference - of_incident - distance) * normal,
          distance - (of_reference + of_incident)};
}

/// The point between the nearest places on both cores.
inline PointOf single_point(const Float2& on_first, const Float2& on_second, const Float2& normal,
                            float separation, const Placed& placed) {
  const Float2 from = on_first + placed.first.radius * normal;
  const Float2 to = on_second + -placed.second.radius * normal;
  return {lerp(from, to, 0.5F), separation};
}

/// What was found in the first one's frame, from it to the second.
struct Found {
  Float2 normal{0, 0};            ///< as long as the engine makes it
  std::vector<PointOf> points{};  ///< those across gaps too
  bool is_clipped = false;        ///< the rest as in ContactOfBox2d3
  bool is_disjoint = false;
  bool is_unclipped = false;
  bool are_apart = false;
  bool is_beyond_range = false;
};

/// b2CollideCapsules.
Found collide_capsules(const Placed& placed);

}  // namespace manifuzz::ledger_of::box2d3
