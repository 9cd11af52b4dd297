#include "oracle/bullet/ledger/repeated_query.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "judging/faults/differences.hpp"

namespace manifuzz::ledger_of {
namespace {

BulletPair hulls_of(const PairCase& pair, BulletAsked asked) {
  return asked == BulletAsked::flat ? flat_hulls_of(pair) : prisms_of(pair);
}

/// How far a hull's corner is along an axis of the world, in double; of its origin nothing.
double along(const Space& axis, const BulletPlace& place, const Space& corner) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const Space& row = place.basis[static_cast<std::size_t>(i)];
    for (int j = 0; j < 3; ++j) {
      sum += static_cast<double>(axis[i]) * static_cast<double>(row[j]) *
             static_cast<double>(corner[j]);
    }
  }
  return sum;
}

/// By how much the farthest corner along an axis is farther than the one that a hull gives.
double missed_along(const Space& axis, const BulletPlace& place, const BulletHull& hull) {
  const double found = along(axis, place, hull.farthest(place.to_local(axis)));
  double most = found;
  for (const Space& corner : hull.corners) most = std::max(most, along(axis, place, corner));
  return most - found;
}

}  // namespace

RepeatedQuery repeat_query(const PairCase& pair, BulletAsked asked) {
  RepeatedQuery query;
  query.asked = asked;
  const BulletPair hulls = hulls_of(pair, asked);
  if (asked == BulletAsked::epa) {
    query.answer = ask_detector(hulls, solve_by_epa, &query.epa, 1e18F);
    return query;
  }
  query.answer =
      ask_detector(hulls, solve_by_directions, &query.directions, farthest_square_of(hulls));
  return query;
}

bool is_answered(const Deviation& d, const RepeatedQuery& query) {
  const BulletAnswer& answer = query.answer;
  const double bound = d.right.bounds.separation;
  const auto distance = static_cast<double>(answer.distance);
  const bool is_found = answer.normal_of != NormalOf::nobody;
  if (d.got.count == 0) return !is_found || distance >= -bound;
  const double said = deepest(d.got);
  if (!is_found || (said >= 0 && distance > bound)) return false;
  const Vector2<double> normal(static_cast<double>(-answer.normal.x()),
                               static_cast<double>(-answer.normal.y()));
  const double in_plane = normal.norm();
  constexpr double roundings = 4 * std::numeric_limits<float>::epsilon();
  const Vector2<double> got =
      rotate<double>(d.right.pair().a.pose.rotation.cast<double>(), d.got.normal).normalized();
  const double depth = said < 0 ? -distance * in_plane : std::max(-distance * in_plane, 0.0);
  // A solver's depth may be far larger than the shapes, and rounded as such; one that is left of a
  // displacement is rounded as that was. A manifold takes places to both frames and back, by
  // rotations that lengthen them.
  const double largest = std::max(std::abs(depth), static_cast<double>(query.directions.moved));
  const double lengthened =
      roundings + rotation_defect(d.right.pair().a) + rotation_defect(d.right.pair().b);
  return (got - normal / in_plane).norm() <= roundings &&
         std::abs(said - depth) <= bound + lengthened * largest;
}

bool is_nearest_corner_rounded(const PairCase& pair, BulletAsked asked, const QueryLoop& loop) {
  constexpr double relative_error = 1e-6;
  if (loop.end != QueryEnd::equal_vertex || loop.is_by_threshold || loop.is_closest_rounded) {
    return false;
  }
  const BulletPair hulls = hulls_of(pair, asked);
  // The axis is from B to A.
  const double nearer = missed_along(Space(-loop.axis), hulls.place_a, hulls.a) +
                        missed_along(loop.axis, hulls.place_b, hulls.b);
  return nearer > 0 && nearer <= relative_error * static_cast<double>(loop.square);
}

}  // namespace manifuzz::ledger_of
