#pragma once

#include <algorithm>
#include <functional>
#include <vector>

#include "exact/placed.hpp"
#include "geometry/pair_case.hpp"

namespace manifuzz {

/// A body's rotation as the adapter hands it over, and the length that the vertices take.
struct UnitRotation {
  Vector2<double> unit;
  double length = 1;
};

UnitRotation unit_rotation(const Pose<float>& pose);

/// Two shapes of faces in the frame in which phaser-box2d collides them: the first one's, from its
/// vertex 0. The operations are the adapter's and the engine's in their order, so that the numbers
/// are the engine's to the last bit.
struct PlacedByPhaser {
  exact::RoughPolygon first;   ///< A, or B where A is a capsule and B a polygon
  exact::RoughPolygon second;  ///< the other
  bool is_swapped = false;     ///< B is the first
  Vector2<double> rotation;    ///< the first one's frame in the world, unit
};

PlacedByPhaser placed_by_phaser(const PairCase& pair);

/// The depths of an answer's points, the deepest first.
inline std::vector<double> sorted_depths(const Manifold<double>& got) {
  std::vector<double> depths(static_cast<std::size_t>(got.count));
  std::ranges::transform(got.points.begin(), got.points.begin() + got.count, depths.begin(),
                         &ContactPoint<double>::depth);
  std::ranges::sort(depths, std::greater());
  return depths;
}

}  // namespace manifuzz
