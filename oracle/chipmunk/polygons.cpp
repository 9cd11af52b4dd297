#include <algorithm>
#include <cmath>

#include "exact/placed.hpp"
#include "oracle/chipmunk/deviations.hpp"

// Chipmunk on polygons: GJK and EPA, whose normals are those of the difference of both.

namespace manifuzz {
std::vector<Vector2<double>> differences_of_vertices(const PairCase& pair) {
  const exact::RoughPair placed = exact::place_roughly(pair);
  std::vector<Vector2<double>> all;
  for (int j = 0; j < placed.b.count; ++j) {
    for (int i = 0; i < placed.a.count; ++i) {
      all.push_back(placed.b.vertices[j] - placed.a.vertices[i]);
    }
  }
  return all;
}

bool corner_on_corner(const Deviation& d) {
  if (is_round(d.right.pair())) return false;
  const bool is_reversed = d.kind == Kind::reversed && munk::is_given_by_any(d);
  const bool fits = d.kind == Kind::normal || d.kind == Kind::missed_contact || is_reversed;
  return fits && std::ranges::any_of(differences_of_vertices(d.right.pair()),
                                     [&](const Vector2<double>& apart) {
                                       return apart.norm() <= d.right.bounds.separation;
                                     });
}

bool collinear_and_apart(const Deviation& d) {
  if (d.kind != Kind::phantom_contact || is_round(d.right.pair())) return false;
  const auto all = differences_of_vertices(d.right.pair());
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
