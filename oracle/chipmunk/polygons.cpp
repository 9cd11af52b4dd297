#include <algorithm>
#include <cmath>
#include <vector>

#include "exact/placed.hpp"
#include "judging/faults/shared_faults.hpp"
#include "oracle/chipmunk/deviations.hpp"

// Chipmunk on polygons: GJK and EPA, whose normals are those of the difference of both.

namespace manifuzz {
namespace {

/// The vertices in the world, from A's position.
std::vector<Vector2<double>> placed(const PairCase& pair, Side side) {
  std::vector<Vector2<double>> vertices;
  for (int i = 0; i < pair[side].polygon.count; ++i) {
    const exact::Point<double> at = exact::vertex<double>(pair, side, i);
    vertices.emplace_back(at.x, at.y);
  }
  return vertices;
}

/// B's vertices minus A's: the corners, and more, of what GJK walks on.
std::vector<Vector2<double>> differences(const PairCase& pair) {
  std::vector<Vector2<double>> all;
  for (const auto& b : placed(pair, Side::b)) {
    for (const auto& a : placed(pair, Side::a)) all.push_back(b - a);
  }
  return all;
}

}  // namespace

bool corner_on_corner(const Deviation& d) {
  if (is_round(d.right.pair())) return false;
  const bool fits = d.kind == Kind::normal || d.kind == Kind::missed_contact;
  return fits &&
         std::ranges::any_of(differences(d.right.pair()), [&](const Vector2<double>& apart) {
           return apart.norm() <= d.right.bounds.separation;
         });
}

bool collinear_and_apart(const Deviation& d) {
  if (d.kind != Kind::phantom_contact || is_round(d.right.pair())) return false;
  const auto all = differences(d.right.pair());
  const double bound = 4 * d.right.bounds.separation;  // which the differences are rounded within
  return std::ranges::any_of(all, [&](const Vector2<double>& from) {
    return std::ranges::any_of(all, [&](const Vector2<double>& to) {
      const Vector2<double> along = to - from;
      const double length = along.norm();
      return length > bound && from.dot(along) >= 0 &&
             std::abs(from.x() * along.y() - from.y() * along.x()) <= bound * length;
    });
  });
}

bool neighbours_nearly_parallel(const Deviation& d) {
  if (is_round(d.right.pair())) return false;
  if (d.kind != Kind::count && d.kind != Kind::position && d.kind != Kind::missed_contact) {
    return false;
  }
  const PairCase& pair = d.right.pair();
  for (const Side side : {Side::a, Side::b}) {
    const ConvexPolygon<float>& polygon = pair[side].polygon;
    for (int i = 0; i < polygon.count; ++i) {
      const exact::FaceOf face{side, i};
      const exact::FaceOf next{side, polygon.next(i)};
      const double lengths = ledger_of::length_of(pair, face) * ledger_of::length_of(pair, next);
      const double dot =
          exact::dot(exact::direction<double>(pair, face), exact::direction<double>(pair, next));
      if (dot >= (1 - d.right.bounds.incident_dot) * lengths) return true;
    }
  }
  return false;
}

}  // namespace manifuzz
