#include <algorithm>

#include "oracle/jbox2d/deviations.hpp"

namespace manifuzz {

bool edge_radius_of_settings(const Deviation& d) {
  constexpr double kRadius = 2 * 0.01F;  // 2.0f * Settings.polygonRadius
  const PairCase& pair = d.right.pair();
  const bool has_edge = std::min(pair.a.polygon.count, pair.b.polygon.count) == 2;
  const bool has_polygon = std::max(pair.a.polygon.count, pair.b.polygon.count) >= kMinVertices;
  if (!has_edge || !has_polygon || d.got.count > 0 || total_radius(pair) <= kRadius) return false;
  const exact::Truth& truth = *d.right.truth;
  return std::max(truth.separation(Side::a), truth.separation(Side::b)) >
         kRadius - 2 * d.right.bounds.separation;
}

}  // namespace manifuzz
