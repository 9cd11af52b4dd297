#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "judging/judge.hpp"
#include "own_colliders/own_colliders.hpp"

// Pairs whose right contacts are known by hand, and changes of these.

namespace manifuzz::known_by_hand {

inline ConvexPolygon<float> polygon(const std::vector<Vector2<float>>& corners) {
  return make_polygon<float>(corners, 0);
}

/// A box of half-width 1 and on its top face a triangle whose lower edge rises by 0.04: the right
/// points are 0.1 and 0.06 deep, at x = -0.5 and 0.5, and the triangle is sqrt(1.25) across.
inline PairCase leaning() {
  PairCase pair;
  pair.a.polygon = polygon({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
  pair.b.polygon = polygon({{-0.5F, 0}, {0.5F, 0.04F}, {0, 1}});
  pair.b.pose.position = {0, 0.9F};
  return pair;
}
inline const double kLeaning = std::sqrt(1.25);

/// The triangle stands on its corner: one right point, (0, 0.9), 0.1 deep; it is sqrt(16.25)
/// across, the box sqrt(8).
inline PairCase standing_on_corner() {
  PairCase pair = leaning();
  pair.b.polygon = polygon({{0, 0}, {2, 0.5F}, {-2, 1}});
  return pair;
}
inline const double kOnCorner = std::sqrt(8.0);

/// Boxes that overlap by 0.1 in x and by `by` in y.
inline PairCase boxes(float by) {
  PairCase pair;
  pair.a.polygon = polygon({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
  pair.b.polygon = pair.a.polygon;
  pair.b.pose.position = {1.9F, 2 - by};
  return pair;
}

inline Manifold<double> right_of(const PairCase& pair) {
  return std::get<Manifold<double>>(make_clip64().collide(pair));
}

inline Declaration declared() {
  return make_clip64().declaration;
}

inline Judgement judged(const PairCase& pair, const Answer& answer,
                        const Declaration& declaration = declared()) {
  const Collider oracle = make_clip64();
  const Answer of_oracle = oracle.collide(pair);
  return judge(pair, {declaration, answer}, {oracle.declaration, of_oracle});
}

using Change = std::function<void(Manifold<double>&)>;

inline Change wrong_side() {
  return [](Manifold<double>& m) { m.reference = other(m.reference); };
}
inline Change wrong_feature() {
  return [](Manifold<double>& m) { m.points[0].features.a.index ^= 1; };
}
inline Change moved(int point, double x, double y) {
  return [=](Manifold<double>& m) { m.points[point].position += Vector2<double>(x, y); };
}
inline Change deeper(int point, double by) {
  return [=](Manifold<double>& m) { m.points[point].depth += by; };
}
inline Change turned(double by) {
  return [=](Manifold<double>& m) {
    m.normal = Vector2<double>(m.normal.x() + by, m.normal.y()).normalized();
  };
}
inline Change without(int point) {
  return [=](Manifold<double>& m) {
    m.points[0] = m.points[1 - point];
    m.count = 1;
  };
}
inline Change with_another(double x, double y, double depth) {
  return [=](Manifold<double>& m) {
    m.points[1] = m.points[0];
    m.points[1].position = {x, y};
    m.points[1].depth = depth;
    m.count = 2;
  };
}

}  // namespace manifuzz::known_by_hand
