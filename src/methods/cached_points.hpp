#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "methods/closest_points.hpp"

namespace manifuzz::methods {

/// With what a kept normal turns.
enum class Carrier : unsigned char {
  a,      ///< A
  b,      ///< B
  world,  ///< nothing
};

/// A point that is kept from frame to frame: plain data. `Scalar` is float or double.
template <class Scalar>
struct CachedPoint {
  int id = 0;                        ///< the same as long as it is kept, or takes its place
  int born = 0;                      ///< the frame in which detection last gave it
  Vector2<Scalar> anchor_a{0, 0};    ///< the point on A's surface, in A's frame
  Vector2<Scalar> anchor_b{0, 0};    ///< the point on B's surface, in B's frame
  Vector2<Scalar> normal{0, 0};      ///< unit, from A to B, in the frame of what carries it
  Carrier carrier = Carrier::a;      ///< with what it turns
  Vector2<Scalar> rotation_b{1, 0};  ///< B's in A's frame when it was born
  Scalar depth = 0;                  ///< the anchors' gap along the normal, a length of A's frame

  friend bool operator==(const CachedPoint&, const CachedPoint&) = default;
};

/// What is kept of a pair: plain data, empty at first.
template <class Scalar>
struct PointCache {
  std::array<CachedPoint<Scalar>, 4> points;  ///< `count` of them
  int count = 0;                              ///< of points: at most 3, in Bullet's way 4
  int frame = 0;                              ///< the number of the next frame
  int next_id = 0;                            ///< of the next point that is added

  /// The points that there are.
  std::span<CachedPoint<Scalar>> all() { return {points.data(), static_cast<std::size_t>(count)}; }
  /// The points that there are.
  std::span<const CachedPoint<Scalar>> all() const {
    return {points.data(), static_cast<std::size_t>(count)};
  }
  friend bool operator==(const PointCache&, const PointCache&) = default;
};

/// How stale a point may become before it is dropped, since its birth.
template <class Scalar>
struct KeepLimits {
  Scalar gap = 0;    ///< the greatest between its anchors along the normal, a length
  Scalar drift = 0;  ///< of its anchors across the normal, a length
  Scalar turn = 0;   ///< of B against A, in radians
  Scalar match = 0;  ///< how near a new point takes its place, a length
};

/// What a point may move by, as a share of the smaller shape's reach: the arm of a force is off by
/// no more than that.
inline constexpr double kKeptShare = 0.02;

/// The limits of shapes of which the smaller one reaches so far from its origin: a turn moves what
/// is a reach away by as much as it may drift.
template <class Scalar>
KeepLimits<Scalar> keep_limits(Scalar smaller_reach) {
  const auto share = static_cast<Scalar>(kKeptShare);
  const Scalar length = share * smaller_reach;
  return {length, length, share, length};
}

/// What a detection of one point says of a pair, in A's frame.
template <class Scalar>
struct DetectedPoint {
  Vector2<Scalar> normal{0, 0};  ///< unit, from A to B
  Vector2<Scalar> on_a{0, 0};    ///< where it is on A's surface: a depth farther along the normal
  Vector2<Scalar> on_b{0, 0};    ///< where it is on B's
  Side carrier = Side::a;        ///< whose face the normal is of
};

/// The point of a manifold as detected: it is on the incident core of mitred polygons and on the
/// incident surface of round ones. Skins are a radius along the normal from their cores.
template <class Scalar>
DetectedPoint<Scalar> detected_point(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b,
                                     const Manifold<Scalar>& manifold, int index = 0) {
  const ContactPoint<Scalar>& point = manifold.points[index];
  const Vector2<Scalar>& normal = manifold.normal;
  const bool is_on_surface = are_round(a, b);
  DetectedPoint<Scalar> found{normal, point.position, point.position, manifold.reference};
  if (found.carrier == Side::a) {
    if (!is_on_surface) found.on_b -= b.radius * normal;
    found.on_a = found.on_b + point.depth * normal;
  } else {
    if (!is_on_surface) found.on_a += a.radius * normal;
    found.on_b = found.on_a - point.depth * normal;
  }
  return found;
}

/// The normal of a point in A's frame, in which A has `rotation_a` in the world. Rotations need not
/// be quite unit; it is.
template <class Scalar>
Vector2<Scalar> normal_in_a(const CachedPoint<Scalar>& point, const Pose<Scalar>& b_in_a,
                            const Vector2<Scalar>& rotation_a = {1, 0}) {
  const auto unit = [](const Vector2<Scalar>& v, const Vector2<Scalar>& rotation) {
    return Vector2<Scalar>(v / std::sqrt(rotation.dot(rotation)));
  };
  if (point.carrier == Carrier::a) return point.normal;
  if (point.carrier == Carrier::world) {
    return unit(rotate_back(rotation_a, point.normal), rotation_a);
  }
  return unit(rotate(b_in_a.rotation, point.normal), b_in_a.rotation);
}

/// From a point's anchor on B to that on A, in A's frame.
template <class Scalar>
Vector2<Scalar> between_anchors(const CachedPoint<Scalar>& point, const Pose<Scalar>& b_in_a) {
  return point.anchor_a - transform(b_in_a, point.anchor_b);
}

/// The angle in radians by which B has turned against A since a point's birth.
template <class Scalar>
Scalar turn_since_birth(const CachedPoint<Scalar>& point, const Pose<Scalar>& b_in_a) {
  return std::abs(
      std::atan2(cross(point.rotation_b, b_in_a.rotation), point.rotation_b.dot(b_in_a.rotation)));
}

/// Whether a point, its depth brought up to date, is within limits.
template <class Scalar>
bool is_fresh(const CachedPoint<Scalar>& point, const Pose<Scalar>& b_in_a,
              const KeepLimits<Scalar>& limits) {
  const Scalar drift = std::abs(cross(normal_in_a(point, b_in_a), between_anchors(point, b_in_a)));
  return -point.depth <= limits.gap && drift <= limits.drift &&
         turn_since_birth(point, b_in_a) <= limits.turn;
}

/// Leaves the points that `keeps` says yes to, in their order.
template <class Scalar, class Keeps>
void keep_if(PointCache<Scalar>& cache, const Keeps& keeps) {
  int count = 0;
  for (int i = 0; i < cache.count; ++i) {
    if (keeps(cache.points[i])) cache.points[count++] = cache.points[i];
  }
  cache.count = count;
}

/// Measures the depth of every point anew, and drops the stale ones. B stands at `b_in_a`.
template <class Scalar>
void refresh(PointCache<Scalar>& cache, const Pose<Scalar>& b_in_a,
             const KeepLimits<Scalar>& limits) {
  for (CachedPoint<Scalar>& point : cache.all()) {
    point.depth = normal_in_a(point, b_in_a).dot(between_anchors(point, b_in_a));
  }
  keep_if(cache, [&](const CachedPoint<Scalar>& point) { return is_fresh(point, b_in_a, limits); });
}

/// A detected point as it is kept, without an id.
template <class Scalar>
CachedPoint<Scalar> born_point(const PointCache<Scalar>& cache, const Pose<Scalar>& b_in_a,
                               const DetectedPoint<Scalar>& found) {
  const auto in_b = [&](const Vector2<Scalar>& v) { return rotate_inverse(b_in_a.rotation, v); };
  CachedPoint<Scalar> point;
  point.born = cache.frame;
  point.anchor_a = found.on_a;
  point.anchor_b = in_b(found.on_b - b_in_a.position);
  point.normal = found.normal;
  if (found.carrier == Side::b) {
    point.carrier = Carrier::b;
    point.normal = in_b(found.normal) * std::sqrt(b_in_a.rotation.dot(b_in_a.rotation));
  }
  point.rotation_b = b_in_a.rotation;
  point.depth = found.normal.dot(between_anchors(point, b_in_a));
  return point;
}

/// The square of how far two points are from each other: of their anchors on A or on B, whichever
/// are nearer, for a corner of either stays the same point wherever it slides on the other.
template <class Scalar>
Scalar squared_distance(const CachedPoint<Scalar>& p, const CachedPoint<Scalar>& q) {
  const Vector2<Scalar> on_a = p.anchor_a - q.anchor_a;
  const Vector2<Scalar> on_b = p.anchor_b - q.anchor_b;
  return std::min(on_a.dot(on_a), on_b.dot(on_b));
}

/// Adds what was detected, or puts it in the place of the nearest point that is within the match
/// distance, whose id it takes.
template <class Scalar>
void add(PointCache<Scalar>& cache, const Pose<Scalar>& b_in_a, const KeepLimits<Scalar>& limits,
         const DetectedPoint<Scalar>& found) {
  CachedPoint<Scalar> point = born_point(cache, b_in_a, found);
  CachedPoint<Scalar>* matched = nullptr;
  Scalar least = limits.match * limits.match;
  for (CachedPoint<Scalar>& old : cache.all()) {
    const Scalar squared = squared_distance(old, point);
    if (squared > least) continue;
    least = squared;
    matched = &old;
  }
  point.id = matched != nullptr ? matched->id : cache.next_id++;
  (matched != nullptr ? *matched : cache.points[cache.count++]) = point;
}

/// Leaves the deepest point, the last born of equals, and those that are farthest to either side of
/// all along its face: the ends of what holds a body up.
template <class Scalar>
void reduce(PointCache<Scalar>& cache, const Pose<Scalar>& b_in_a) {
  if (cache.count < 3) return;
  const CachedPoint<Scalar>* deepest = &cache.points[0];
  for (const CachedPoint<Scalar>& point : cache.all()) {
    const bool is_as_deep = point.depth == deepest->depth && point.born > deepest->born;
    if (point.depth > deepest->depth || is_as_deep) deepest = &point;
  }
  const Vector2<Scalar> along = counter_clockwise_quarter(normal_in_a(*deepest, b_in_a));
  const auto place = [&](const CachedPoint<Scalar>& point) {
    return along.dot(point.anchor_a + transform(b_in_a, point.anchor_b));
  };
  const CachedPoint<Scalar>* first = &cache.points[0];
  const CachedPoint<Scalar>* last = &cache.points[0];
  for (const CachedPoint<Scalar>& point : cache.all()) {
    if (place(point) < place(*first)) first = &point;
    if (place(point) > place(*last)) last = &point;
  }
  const int ids[] = {deepest->id, first->id, last->id};
  keep_if(cache, [&](const CachedPoint<Scalar>& point) {
    return point.id == ids[0] || point.id == ids[1] || point.id == ids[2];
  });
}

/// One frame: what is kept is brought up to date, and what `detect` finds joins it. B stands at
/// `b_in_a` in A's frame (see `relative_pose`), and nothing else of where both are counts: moving
/// them together changes nothing. `detect()` gives an optional DetectedPoint.
template <class Scalar, class Detect>
void next_frame(PointCache<Scalar>& cache, const Pose<Scalar>& b_in_a,
                const KeepLimits<Scalar>& limits, const Detect& detect) {
  refresh(cache, b_in_a, limits);
  const std::optional<DetectedPoint<Scalar>> found = detect();
  if (found) add(cache, b_in_a, limits, *found);
  reduce(cache, b_in_a);
  ++cache.frame;
}

}  // namespace manifuzz::methods
