#include "judging/faults/shared_faults.hpp"

#include <algorithm>
#include <limits>

#include "judging/faults/seen_along.hpp"
#include "judging/manifold_error.hpp"

namespace manifuzz {

using namespace ledger_of;

bool no_contact_on_tied_features(const Deviation& d) {
  return misses_overlap(d) && (may_be_empty_from(d, Side::a) || may_be_empty_from(d, Side::b));
}

bool normal_of_rounded_vertices(const Deviation& d) {
  constexpr double u = std::numeric_limits<double>::epsilon() / 2;
  if (d.kind != Kind::normal) return false;
  const PairCase& pair = d.right.pair();
  double reach = d.right.truth->extent();
  for (const Side side : {Side::a, Side::b}) {
    reach = std::max(reach, pair[side].pose.position.cast<double>().norm());
  }
  return any_candidate(d, [&](const exact::Clip& clip) {
    // Two vertices, each rounded by a rotation (2.42 u) and a sum (u), over the face's length.
    const double bound = d.right.bounds.normal + 7 * u * reach / length_of(pair, clip.reference);
    return is_near_normal(clip, d.got.normal, bound);
  });
}

bool direction_to_place_on_segment(const Deviation& d) {
  const PairCase& pair = d.right.pair();
  if (d.got.count != 1 || order_of(pair.a) + order_of(pair.b) != 3 || !is_as_deep_as_there(d)) {
    return false;
  }
  // As CircleToSegment computes it, in the world.
  const Side circle = is_swapped(pair) ? Side::b : Side::a;
  const auto placed = [&](Side side, int i) {
    const Vector2<double> v = pair[side].polygon.vertices[i].cast<double>();
    const Vector2<double> turn = pair[side].pose.rotation.cast<double>();
    const Vector2<double> at = pair[side].pose.position.cast<double>();
    return Vector2<double>(turn.x() * v.x() + -turn.y() * v.y() + at.x(),
                           turn.y() * v.x() + turn.x() * v.y() + at.y());
  };
  const Vector2<double> centre = placed(circle, 0);
  const Vector2<double> from = placed(other(circle), 0);
  const Vector2<double> along = placed(other(circle), 1) - from;
  const double share = std::clamp(along.dot(centre - from) / along.dot(along), 0.0, 1.0);
  const Vector2<double> delta = from + share * along - centre;
  // What is rounded in the world has nothing left but roundings where they are at one place.
  const double bound = d.right.bounds.normal + 2 * d.right.bounds.separation / delta.norm();
  Vector2<double> normal = SeenAlong(pair, d.got.normal).normal();
  if (circle == Side::b) normal = -normal;
  return (normal - delta.normalized()).norm() <= std::min(bound, 1e-3);
}

}  // namespace manifuzz
