#include "judging/faults/circle_faults.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "exact/placed.hpp"

namespace manifuzz::ledger_of {
namespace {

/// The answer's normal in the world, unit.
Vector2<double> given_normal(const Deviation& d) {
  return exact::seen_from_a(d.right.pair(), d.got.normal).normalized();
}

bool has_circle(const PairCase& pair) {
  return pair.a.polygon.count == 1 || pair.b.polygon.count == 1;
}

/// Whether the depth is that of cores that far apart.
bool is_depth_of(const Deviation& d, double distance) {
  return std::abs(d.got.points[0].depth - (total_radius(d.right.pair()) - distance)) <=
         4 * d.right.bounds.separation;
}

/// A polygon's faces whose separation is the greatest, within the bound.
std::vector<int> faces_tied_with_greatest(const Deviation& d, Side side, double bound) {
  const exact::Truth& truth = *d.right.truth;
  std::vector<int> tied;
  if (d.right.pair()[side].polygon.count < kMinVertices) return tied;
  for (int i = 0; i < d.right.pair()[side].polygon.count; ++i) {
    if (truth.separation({side, i}) >= truth.separation(side) - bound) tied.push_back(i);
  }
  return tied;
}

}  // namespace

bool is_axis_within(const Deviation& d, double epsilon) {
  const PairCase& pair = d.right.pair();
  if (d.got.count != 1 || !has_circle(pair)) return false;
  const double bound = epsilon + 2 * d.right.bounds.separation;
  const exact::RoughPair placed = exact::place_roughly(pair);
  // The world's x axis, from the first shape: an edge, a polygon, or A.
  const bool is_turned = pair.a.polygon.count == 1 && pair.b.polygon.count > 1;
  const Vector2<double> axis(is_turned ? -1 : 1, 0);
  if ((given_normal(d) - axis).norm() > 2 * d.right.bounds.normal) return false;
  for (int i = 0; i < placed.a.count; ++i) {
    for (int j = 0; j < placed.b.count; ++j) {
      const Vector2<double> apart = placed.b.vertices[j] - placed.a.vertices[i];
      if (apart.norm() <= bound && is_depth_of(d, apart.dot(axis))) return true;
    }
  }
  return false;
}

bool is_end_of_tied_face(const Deviation& d) {
  const PairCase& pair = d.right.pair();
  if (d.got.count > 1 || !has_circle(pair)) return false;
  const Side side = pair.a.polygon.count == 1 ? Side::b : Side::a;
  const double bound = 2 * d.right.bounds.separation;
  const std::vector<int> tied = faces_tied_with_greatest(d, side, bound);
  if (tied.size() < 2 || d.right.truth->separation(side) < -bound) return false;
  const exact::RoughPair placed = exact::place_roughly(pair);
  const Vector2<double>& centre = placed[other(side)].vertices[0];
  const auto is_answer_from = [&](const Vector2<double>& apart) {
    const double distance = apart.norm();
    if (d.got.count == 0) return distance >= total_radius(pair) - bound;
    const Vector2<double> normal = (side == Side::a ? apart : Vector2<double>(-apart)) / distance;
    return (given_normal(d) - normal).norm() <= 2 * d.right.bounds.normal + bound / distance &&
           is_depth_of(d, distance);
  };
  return std::ranges::any_of(tied, [&](int face) {
    const Vector2<double>& from = placed[side].vertices[face];
    const Vector2<double>& to = placed[side].vertices[pair[side].polygon.next(face)];
    const Vector2<double> along = (to - from).normalized();
    return ((centre - from).dot(along) <= bound && is_answer_from(centre - from)) ||
           ((centre - to).dot(along) >= -bound && is_answer_from(centre - to));
  });
}

bool is_face_within(const Deviation& d, double epsilon) {
  const PairCase& pair = d.right.pair();
  if (d.got.count != 1 || !has_circle(pair)) return false;
  const Side side = pair.a.polygon.count == 1 ? Side::b : Side::a;
  const exact::Truth& truth = *d.right.truth;
  const double bound = 2 * d.right.bounds.separation;
  if (std::abs(truth.separation(side)) > epsilon + bound) return false;
  const exact::RoughPair placed = exact::place_roughly(pair);
  return std::ranges::any_of(faces_tied_with_greatest(d, side, bound), [&](int face) {
    const Vector2<double>& out = placed[side].normals[face];
    const Vector2<double> normal = side == Side::a ? out : Vector2<double>(-out);
    return (given_normal(d) - normal).norm() <= 2 * d.right.bounds.normal &&
           is_depth_of(d, truth.separation({side, face}));
  });
}

}  // namespace manifuzz::ledger_of
