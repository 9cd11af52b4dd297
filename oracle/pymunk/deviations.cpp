#include "oracle/pymunk/deviations.hpp"

#include "exact/placed.hpp"

namespace manifuzz {
namespace {

/// The middle of the box around a core, in world directions seen from A's position.
Vector2<double> middle_of(const exact::RoughPolygon& core) {
  Vector2<double> low = core.vertices[0];
  Vector2<double> high = low;
  for (int i = 1; i < core.count; ++i) {
    low = low.cwiseMin(core.vertices[i]);
    high = high.cwiseMax(core.vertices[i]);
  }
  return 0.5 * (low + high);
}

}  // namespace

bool zero_normal_of_one_middle(const Deviation& d) {
  if (d.got.count == 0 || !d.got.normal.isZero(0)) return false;
  for (int i = 0; i < d.got.count; ++i) {
    if (d.got.points[i].depth != 0) return false;
  }
  const exact::RoughPair placed = exact::place_roughly(d.right.pair());
  return (middle_of(placed.a) - middle_of(placed.b)).norm() <= 4 * d.right.bounds.separation;
}

}  // namespace manifuzz
