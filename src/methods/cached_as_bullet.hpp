#pragma once

#include <algorithm>

#include "geometry/angular_disc.hpp"
#include "methods/cached_points.hpp"

// Contact points kept as Bullet keeps them in a btPersistentManifold, rule by rule, in the
// plane: to see what its rules do to any detection, without what its float positions in the world
// do. Each function says which of Bullet's has its rule.

namespace manifuzz::methods {

/// Within which length Bullet takes two points for one, and beyond which it drops one.
/// btCollisionDispatcher::getNewManifold, btCollisionShape::getContactBreakingThreshold
/// (gContactBreakingThreshold is 0.02).
template <class Scalar>
Scalar bullet_threshold(const ConvexPolygon<Scalar>& a, const ConvexPolygon<Scalar>& b) {
  return static_cast<Scalar>(0.02) * std::min(angular_disc(a), angular_disc(b));
}

/// Measures every depth anew, along normals that stay as they were in the world, and drops what is
/// farther apart than the threshold along them or across, the last point taking its slot.
/// btPersistentManifold::refreshContactPoints, removeContactPoint. A has `rotation_a` in the world.
template <class Scalar>
void refresh_as_bullet(PointCache<Scalar>& cache, const Pose<Scalar>& b_in_a,
                       const Vector2<Scalar>& rotation_a, Scalar threshold) {
  for (int i = cache.count - 1; i >= 0; --i) {
    CachedPoint<Scalar>& point = cache.points[i];
    const Vector2<Scalar> normal = normal_in_a(point, b_in_a, rotation_a);
    const Vector2<Scalar> between = between_anchors(point, b_in_a);
    point.depth = normal.dot(between);
    const bool is_kept = -point.depth <= threshold && std::abs(cross(normal, between)) <= threshold;
    if (!is_kept) point = cache.points[--cache.count];
  }
}

/// The slot of the nearest point by the anchor on A alone, within the threshold; -1 where there is
/// none. btPersistentManifold::getCacheEntry.
template <class Scalar>
int matching_slot(const PointCache<Scalar>& cache, const CachedPoint<Scalar>& found,
                  Scalar threshold) {
  int nearest = -1;
  Scalar least = threshold * threshold;
  for (int i = 0; i < cache.count; ++i) {
    const Vector2<Scalar> apart = cache.points[i].anchor_a - found.anchor_a;
    if (apart.dot(apart) >= least) continue;
    least = apart.dot(apart);
    nearest = i;
  }
  return nearest;
}

/// Which of 4 points one more takes the slot of: where it leaves the largest area by the anchors on
/// A. Of the deepest the area is taken to be 0; so are all where the anchors are on one line, as on
/// a face of A, and the first slot goes, be it the deepest. Depths are those of the frame before.
/// btPersistentManifold::sortCachedPoints.
template <class Scalar>
int slot_to_replace(const PointCache<Scalar>& cache, const CachedPoint<Scalar>& found) {
  int deepest = -1;
  Scalar greatest_depth = found.depth;
  for (int i = 0; i < 4; ++i) {
    if (cache.points[i].depth <= greatest_depth) continue;
    greatest_depth = cache.points[i].depth;
    deepest = i;
  }
  constexpr int kOthers[4][3] = {{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}};
  int slot = 0;
  Scalar largest = -1;
  for (int i = 0; i < 4; ++i) {
    const auto& [first, second, third] = kOthers[i];
    const Scalar area = cross<Scalar>(found.anchor_a - cache.points[first].anchor_a,
                                      cache.points[third].anchor_a - cache.points[second].anchor_a);
    const Scalar squared = i == deepest ? 0 : area * area;
    if (squared <= largest) continue;
    largest = squared;
    slot = i;
  }
  return slot;
}

/// Adds what was detected, or puts it in the place of the point that it matches, whose id it takes.
/// btManifoldResult::addContactPoint, btPersistentManifold::replaceContactPoint, addManifoldPoint.
template <class Scalar>
void add_as_bullet(PointCache<Scalar>& cache, const Pose<Scalar>& b_in_a,
                   const Vector2<Scalar>& rotation_a, Scalar threshold,
                   const DetectedPoint<Scalar>& found) {
  CachedPoint<Scalar> point = born_point(cache, b_in_a, found);
  if (-point.depth > threshold) return;
  point.carrier = Carrier::world;
  point.normal = rotate(rotation_a, found.normal) / std::sqrt(rotation_a.dot(rotation_a));
  const int matched = matching_slot(cache, point, threshold);
  point.id = matched >= 0 ? cache.points[matched].id : cache.next_id++;
  if (matched >= 0) {
    cache.points[matched] = point;
  } else {
    cache.points[cache.count < 4 ? cache.count++ : slot_to_replace(cache, point)] = point;
  }
}

/// One frame: what `detect` finds, an optional DetectedPoint, joins what is kept, and then all is
/// brought up to date. btConvexConvexAlgorithm::processCollision. B stands at `b_in_a` in A's
/// frame, and A has `rotation_a` in the world.
template <class Scalar, class Detect>
void next_frame_as_bullet(PointCache<Scalar>& cache, const Pose<Scalar>& b_in_a,
                          const Vector2<Scalar>& rotation_a, Scalar threshold,
                          const Detect& detect) {
  const std::optional<DetectedPoint<Scalar>> found = detect();
  if (found) add_as_bullet(cache, b_in_a, rotation_a, threshold, *found);
  refresh_as_bullet(cache, b_in_a, rotation_a, threshold);
  ++cache.frame;
}

}  // namespace manifuzz::methods
