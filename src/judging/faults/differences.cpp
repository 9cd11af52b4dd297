#include "judging/faults/differences.hpp"

#include <algorithm>
#include <cmath>

#include "exact/curve.hpp"

namespace manifuzz {
namespace ledger_of {
namespace {

double turn_of(const Vector2<double>& a, const Vector2<double>& b, const Vector2<double>& c) {
  return cross<double>(b - a, c - a);
}

/// One half of a hull, of places in the order that it goes through them.
template <class Range>
void append_half(std::vector<Vector2<double>>& hull, const Range& places) {
  const std::size_t first = hull.size();
  for (const Vector2<double>& place : places) {
    while (hull.size() >= first + 2 && turn_of(hull[hull.size() - 2], hull.back(), place) <= 0) {
      hull.pop_back();
    }
    hull.push_back(place);
  }
  hull.pop_back();
}

}  // namespace

Difference::Difference(const PairCase& pair) {
  const exact::RoughPair placed = exact::place_roughly(pair);
  std::vector<Vector2<double>> all;
  for (int i = 0; i < placed.a.count; ++i) {
    for (int j = 0; j < placed.b.count; ++j) {
      all.push_back(placed.a.vertices[i] - placed.b.vertices[j]);
    }
  }
  std::ranges::sort(all, {}, [](const Vector2<double>& v) { return std::pair(v.x(), v.y()); });
  all.erase(std::unique(all.begin(), all.end()), all.end());
  corners_ = all;
  if (all.size() < 3) return;
  corners_.clear();
  append_half(corners_, all);
  std::ranges::reverse(all);
  append_half(corners_, all);
}

double Difference::reach(const Vector2<double>& along) const {
  return farthest(along).dot(along);
}

const Vector2<double>& Difference::farthest(const Vector2<double>& along) const {
  return *std::ranges::max_element(
      corners_, {}, [&](const Vector2<double>& corner) { return corner.dot(along); });
}

double Difference::distance_from(const Vector2<double>& place) const {
  bool is_inside = corners_.size() > 2;
  double nearest = INFINITY;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    nearest = std::min(nearest, distance_to_segment(place, corners_[i], after(i)));
    is_inside = is_inside && turn_of(corners_[i], after(i), place) >= 0;
  }
  return is_inside ? 0 : nearest;
}

std::vector<Vector2<double>> nearest_places(const PairCase& pair, Side side) {
  const exact::RoughPair placed = exact::place_roughly(pair);
  const exact::RoughPolygon& core = placed[side];
  const exact::RoughPolygon& opposite = placed[other(side)];
  const Vector2<double> origin = pair.a.pose.position.cast<double>();
  std::vector<Vector2<double>> places;
  for (int i = 0; i < core.count; ++i) {
    places.push_back(origin + core.vertices[i]);
    for (int j = 0; j < opposite.count; ++j) {
      places.push_back(origin + nearest_on_segment(opposite.vertices[j], core.vertices[i],
                                                   core.vertices[core.next(i)]));
    }
  }
  return places;
}

bool is_of_points(Kind kind) {
  return kind == Kind::witness || kind == Kind::extent || kind == Kind::count;
}

double deepest(const Manifold<double>& manifold) {
  double most = manifold.count > 0 ? -INFINITY : 0;
  for (int i = 0; i < manifold.count; ++i) most = std::max(most, manifold.points[i].depth);
  return most;
}

Vector2<double> translation_of(const Deviation& d) {
  return deepest(d.got) * exact::seen_from_a(d.right.pair(), d.got.normal).normalized();
}

double least_depth(const Deviation& d) {
  return exact::PenetrationCurve(*d.right.truth, exact::skin_of(*d.right.truth)).least();
}

bool is_translation_right(const Deviation& d, double bound) {
  if (d.got.count == 0 || d.got.normal.isZero(0) || is_of_points(d.kind)) return false;
  const exact::PenetrationCurve curve(*d.right.truth, exact::skin_of(*d.right.truth));
  const Vector2<double> got = translation_of(d);
  return std::ranges::any_of(curve.minima(bound), [&](const Vector2<double>& normal) {
    return (got - curve.least() * exact::seen_from_a(d.right.pair(), normal).normalized()).norm() <=
           bound;
  });
}

}  // namespace ledger_of

}  // namespace manifuzz
