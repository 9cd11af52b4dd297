#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "judging/by_curve.hpp"
#include "judging/ledger/round_deviations.hpp"

// What ports have beside what they were ported from: Munk2D and cp of Chipmunk, jbox2d of Box2D.

namespace manifuzz {
namespace {

/// By which cp makes the length of a normal longer before it divides by it.
constexpr double kAddedByCp = 1e-15;

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

/// Whether a normal lacks as much of a unit vector as one made of a vector of that length.
bool is_short_by(double missing, double length, double bound) {
  constexpr double u = std::numeric_limits<double>::epsilon() / 2;
  const double expected = kAddedByCp / length;
  return std::abs(missing - expected) <= 6 * u + expected * bound / length;
}

/// Whether it is made of a chord of the cores' difference, or of the distance between both.
bool is_short_as_made(const Deviation& d, double missing) {
  const exact::RoughPair placed = exact::place_roughly(d.right.pair());
  const double bound = 4 * d.right.bounds.separation;
  const double apart =
      total_radius(d.right.pair()) -
      exact::PenetrationCurve(*d.right.truth, exact::skin_of(*d.right.truth)).least();
  if (apart > bound && is_short_by(missing, apart, bound)) return true;
  std::vector<Vector2<double>> all;
  for (int j = 0; j < placed.b.count; ++j) {
    for (int i = 0; i < placed.a.count; ++i) {
      all.push_back(placed.b.vertices[j] - placed.a.vertices[i]);
    }
  }
  return std::ranges::any_of(all, [&](const Vector2<double>& from) {
    return std::ranges::any_of(all, [&](const Vector2<double>& to) {
      const double length = (to - from).norm();
      return length > bound && is_short_by(missing, length, bound);
    });
  });
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

bool normal_short_by_cp(const Deviation& d) {
  const double length = d.got.normal.norm();
  if (d.got.count == 0 || !(length > 0 && length < 1)) return false;
  const double missing = 1 / length - 1;
  if (missing <= d.right.bounds.normal || !is_short_as_made(d, missing)) return false;
  Manifold<double> unit = d.got;
  unit.normal /= length;
  const Deviation mended{d.right, unit, d.kind};
  if (!is_round(d.right.pair())) return normal_of_rounded_vertices(mended);
  return is_right_of_chipmunk(mended) || sign_of_swapped_distance(mended) ||
         sign_of_polygon_radius(mended) || direction_to_place_on_segment(mended);
}

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
