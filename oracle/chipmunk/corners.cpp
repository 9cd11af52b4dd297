#include <algorithm>
#include <cmath>
#include <vector>

#include "oracle/chipmunk/deviations.hpp"
#include "oracle/chipmunk/search.hpp"

// What Chipmunk 7 and its ports make of a core's corner on the other core: the normal is computed
// here as it is there, in doubles.

namespace manifuzz {
namespace {

munk::Vector world_normal_of(const Deviation& d) {
  return world_normal(d.right.pair(), d.got.normal);
}

/// Whether the answer is what Chipmunk, Munk2D, or cp with no more than they add, make of the case.
bool is_given_by_a_port(const Deviation& d) {
  return munk::is_given_by(munk::kChipmunk, d) || munk::is_given_by(munk::kMunk, d);
}

/// From a corner of A to one of B, where both lie at one place but for roundings.
std::vector<munk::Vector> differences_of_one_place(const Deviation& d) {
  const munk::Shape a = munk::placed({}, d.right.pair().a);
  const munk::Shape b = munk::placed({}, d.right.pair().b);
  std::vector<munk::Vector> found;
  for (const munk::Vector& from : a.corners) {
    for (const munk::Vector& to : b.corners) {
      if ((to - from).norm() <= 4 * d.right.bounds.separation) found.emplace_back(to - from);
    }
  }
  return found;
}

}  // namespace

bool direction_between_corners(const Deviation& d) {
  const PairCase& pair = d.right.pair();
  if (d.got.count == 0 || !is_round(pair) || d.got.normal.isZero(0)) return false;
  if (!is_given_by_a_port(d)) return false;
  const munk::Vector normal = world_normal_of(d);
  const auto differences = differences_of_one_place(d);
  const auto is_along = [&](const munk::Vector& apart) {
    return !apart.isZero(0) && (normal - apart.normalized()).norm() <= d.right.bounds.normal;
  };
  return std::ranges::any_of(differences, [&](const munk::Vector& from) {
    return is_along(from) || std::ranges::any_of(differences, [&](const munk::Vector& to) {
             return is_along(clockwise_quarter<double>(to - from));
           });
  });
}

bool segment_normal_not_unit(const Deviation& d) {
  const PairCase& pair = d.right.pair();
  if (d.kind != Kind::normal || d.got.count != 1) return false;
  for (const Side side : {Side::a, Side::b}) {
    if (pair[side].polygon.count != 2 || pair[other(side)].polygon.count != 1) continue;
    const munk::Shape segment = munk::placed({}, pair[side]);
    const munk::Vector centre = munk::placed({}, pair[other(side)]).corners[0];
    const munk::Vector along = segment.corners[1] - segment.corners[0];
    const double share = munk::clamped01(along.dot(centre - segment.corners[0]) / along.dot(along));
    const munk::Vector normal = side == Side::a ? -segment.normals[0] : segment.normals[0];
    return segment.corners[0] + along * share == centre &&
           std::abs(normal.norm() - 1) > d.right.bounds.normal &&
           (world_normal_of(d) - normal).norm() <= d.right.bounds.normal;
  }
  return false;
}

bool aborts_on_equal_corners(const LostAnswer& lost) {
  return lost.how == Lost::How::crashed &&
         munk::found_by(munk::kChipmunk, lost.pair).has_equal_corners;
}

}  // namespace manifuzz
