#include <algorithm>

#include "exact/curve.hpp"
#include "oracle/box2d3/capsule_editions.hpp"
#include "oracle/box2d3/deviations.hpp"

namespace manifuzz {

using namespace ledger_of;

bool no_normal_within_box2d3_epsilon(const Deviation& d) {
  // At a polygon's corner the depth is taken along the normal.
  const PairCase& pair = d.right.pair();
  const bool has_polygon = std::max(pair.a.polygon.count, pair.b.polygon.count) >= kMinVertices;
  return has_no_normal_within(d, kEpsilonOfBox2d3, ledger_of::least_depth(d)) ||
         (has_polygon && has_no_normal_within(d, kEpsilonOfBox2d3, 0));
}

bool slop_in_box2d3_capsules(const Deviation& d) {
  const PairCase& pair = d.right.pair();
  const auto cores = capsule_cores(pair);
  if (!cores) return false;
  // b2CollideSegmentAndCapsule has the segment first.
  const bool is_swapped = pair.a.polygon.radius > 0 && pair.b.polygon.radius == 0;
  FoundByPhaser found =
      capsules_by_phaser((*cores)[is_swapped ? 1 : 0], (*cores)[is_swapped ? 0 : 1],
                         total_radius(pair), true, {0.1 * kSlopOfPhaser, kEpsilonOfBox2d3});
  if (is_swapped) found.normal = -found.normal;
  return (d.got.count > 0 || found.is_clipped) && is_given(d, found, as_rounded(d));
}

bool one_point_between_corners(const Deviation& d) {
  const exact::PenetrationCurve curve(*d.right.truth, exact::Skin::round);
  return d.kind == Kind::count && d.got.count == 1 && is_round(d.right.pair()) &&
         curve.are_cores_apart() && curve.nearest_vertices().has_value();
}

}  // namespace manifuzz
