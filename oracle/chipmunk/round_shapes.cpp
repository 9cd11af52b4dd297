#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "judging/by_curve.hpp"
#include "judging/faults/seen_along.hpp"
#include "oracle/chipmunk/deviations.hpp"

// Chipmunk 7 on round shapes, in world directions seen from A's position.

namespace manifuzz {

using namespace ledger_of;

namespace {

/// The answer, with the depths of its points along its normal where cpShapesCollide lost them.
Manifold<double> with_depths(const Deviation& d) {
  Manifold<double> manifold = d.got;
  if (manifold.count == 0 || !is_swapped(d.right.pair()) || !is_without_depth(manifold)) {
    return manifold;
  }
  const PairCase& pair = d.right.pair();
  if (order_of(pair.b) == 1) {
    const exact::Along along(*d.right.truth, manifold.normal);
    manifold.points[0].depth = std::max(along.depth(), 0.0);
    return manifold;
  }
  const SeenAlong along(pair, manifold.normal);
  for (int i = 0; i < manifold.count; ++i) {
    ContactPoint<double>& point = manifold.points[i];
    point.depth = std::max(along.depth_at(point.position, d.right.bounds.separation), 0.0);
  }
  return manifold;
}

bool is_right(const Deviation& d, const Manifold<double>& manifold) {
  return judge_by_curve(*d.right.truth, as_chipmunk(), manifold).kind == Kind::none;
}

/// A chord of the difference to which ClosestPointsNew's normal is perpendicular.
struct Chord {
  Vector2<double> from;
  Vector2<double> to;
};

/// Whether the normal is perpendicular to a chord of which `is_at_fault` tells.
template <class Fault>
bool is_across_chord(const Deviation& d, const Fault& is_at_fault) {
  const PairCase& pair = d.right.pair();
  if (!is_as_deep_as_there(d)) return false;
  const Vector2<double> normal = SeenAlong(pair, d.got.normal).normal();
  const double bound = 4 * d.right.bounds.separation;
  const auto all = differences_of_vertices(pair);
  return std::ranges::any_of(all, [&](const Vector2<double>& from) {
    return std::ranges::any_of(all, [&](const Vector2<double>& to) {
      const Vector2<double> along = to - from;
      return along.norm() > bound && std::abs(normal.dot(along)) <= bound &&
             is_at_fault(Chord{from, to});
    });
  });
}

}  // namespace

const Declaration& as_chipmunk() {
  static const Declaration declaration{.scalar = ScalarType::float64,
                                       .frame = RoundingFrame::world,
                                       .min_vertices = 1,
                                       .takes_round = true};
  return declaration;
}

bool sign_of_swapped_distance(const Deviation& d) {
  return is_round(d.right.pair()) && d.got.count > 0 && is_swapped(d.right.pair()) &&
         is_without_depth(d.got) && is_right(d, with_depths(d));
}

bool sign_of_polygon_radius(const Deviation& d) {
  const PairCase& pair = d.right.pair();
  if (d.got.count != 1 || std::min(order_of(pair.a), order_of(pair.b)) != 1 ||
      std::max(order_of(pair.a), order_of(pair.b)) != 3) {
    return false;
  }
  const Side polygon = is_swapped(pair) ? Side::a : Side::b;
  const auto radius = static_cast<double>(pair[polygon].polygon.radius);
  const double least = least_depth(d);
  // The distance between cores, and the radii as they are added to it.
  const double distance = least - 2 * radius;
  const double given = std::max(is_swapped(pair) ? -distance : distance, 0.0);
  const double bound = 2 * d.right.bounds.separation;
  if (!(radius > 0) || std::abs(d.got.points[0].depth - given) > bound) return false;
  Manifold<double> mended = d.got;
  mended.points[0].depth = std::max(least, 0.0);
  // A's frame is as much smaller as its rotation is longer than unit.
  const double scale = pair.a.pose.rotation.cast<double>().norm();
  if (polygon == Side::b) mended.points[0].position -= 2 * radius / scale * d.got.normal;
  return is_right(d, mended);
}

bool normal_across_corner_on_corner(const Deviation& d) {
  if (!is_round(d.right.pair())) return false;
  const double bound = d.right.bounds.separation;
  if (d.got.count == 0) {
    // Along that normal both support edges are far from the corner, and each other.
    return std::ranges::any_of(differences_of_vertices(d.right.pair()),
                               [&](const Vector2<double>& at) { return at.norm() <= bound; });
  }
  return is_across_chord(d, [&](const Chord& chord) { return chord.from.norm() <= bound; });
}

bool normal_across_collinear(const Deviation& d) {
  if (d.got.count == 0 || !is_round(d.right.pair())) return false;
  const double bound = 4 * d.right.bounds.separation;
  return is_across_chord(d, [&](const Chord& chord) {
    const Vector2<double> along = chord.to - chord.from;
    const double off = chord.from.x() * along.y() - chord.from.y() * along.x();
    return chord.from.dot(along) >= 0 && std::abs(off) <= bound * along.norm();
  });
}

bool depth_by_crossing(const Deviation& d) {
  const PairCase& pair = d.right.pair();
  if (!is_round(pair) || order_of(pair.a) == 1 || order_of(pair.b) == 1) return false;
  const exact::PenetrationCurve curve(*d.right.truth, exact::Skin::round);
  const double bound = d.right.bounds.separation;
  Manifold<double> mended = with_depths(d);
  const bool is_missed = mended.count == 0;
  const SeenAlong along(pair, is_missed ? curve.minima(0).front() : mended.normal);
  double off = 2 * bound;
  for (const Side side : {Side::a, Side::b}) {
    double most = 0;
    for (const auto& slope : along.slopes(side, 4 * bound)) {
      const double share = slope.run > bound ? std::min(2 * bound / slope.run, 1.0) : 1.0;
      most = std::max(most, share * slope.rise);
    }
    off += most;
  }
  const double least = curve.least();
  const double deepest = std::max(ledger_of::deepest(mended), 0.0);
  if (std::abs(least - deepest) > off) return false;
  if (is_missed) return true;
  for (int i = 0; i < mended.count; ++i) {
    if (mended.points[i].depth == deepest) mended.points[i].depth = std::max(least, 0.0);
  }
  return judge_by_curve(*d.right.truth, as_chipmunk(), mended).minimal.value_or(true);
}

}  // namespace manifuzz
