#include "sequence/kept_point.hpp"

#include <algorithm>
#include <cmath>

namespace manifuzz {
namespace {

using exact::DoubleDouble;
using exact::FinePoint;

Vector2<double> rounded_unit(const FinePoint& p) {
  const FinePoint unit = unit_of(p);
  return {unit.x.high, unit.y.high};
}

/// A normal of the world as a side carries it, as long as the rotations make it.
FinePoint carried_by(const PairCase& then, const PairCase& now, Side by, const FinePoint& normal) {
  return turned(now[by], turned_back(then[by], normal));
}

double apart_of_units(const Vector2<double>& p, const Vector2<double>& q) {
  return Vector2<double>(p - q).norm();
}

}  // namespace

FinePoint placed_anchor(const PairCase& pair, Side side, const Vector2<double>& anchor) {
  const FinePoint at = turned(pair[side], exact::widen<DoubleDouble>(anchor));
  if (side == Side::a) return at;
  return at + (exact::widen<DoubleDouble>(pair.b.pose.position) -
               exact::widen<DoubleDouble>(pair.a.pose.position));
}

Vector2<double> anchor_b_in_a(const PairCase& pair, const KeptPoint& point) {
  const FinePoint at = turned_back(pair.a, placed_anchor(pair, Side::b, point.anchor_b));
  const auto scale = exact::scale<DoubleDouble>(pair.a);
  return {(at.x / scale).high, (at.y / scale).high};
}

AnchorsNow anchors_now(const PairCase& pair, const KeptPoint& point,
                       const Vector2<double>& normal) {
  const FinePoint to_a =
      placed_anchor(pair, Side::a, point.anchor_a) - placed_anchor(pair, Side::b, point.anchor_b);
  const FinePoint n = exact::widen<DoubleDouble>(normal);
  return {dot(to_a, n).high, std::abs(cross(to_a, n).high)};
}

double place_along(const PairCase& pair, Side side, const Vector2<double>& anchor,
                   const Vector2<double>& direction) {
  return dot(placed_anchor(pair, side, anchor), exact::widen<DoubleDouble>(direction)).high;
}

Vector2<double> carried(const PairCase& then, const PairCase& now, Side by,
                        const Vector2<double>& normal) {
  return rounded_unit(carried_by(then, now, by, exact::widen<DoubleDouble>(normal)));
}

double off_carried(const PairCase& then, const PairCase& now, TravelsWith by,
                   const Vector2<double>& normal_then, const Vector2<double>& normal_now) {
  const FinePoint by_a = carried_by(then, now, Side::a, exact::widen<DoubleDouble>(normal_then));
  const FinePoint by_b = carried_by(then, now, Side::b, exact::widen<DoubleDouble>(normal_then));
  const FinePoint n = exact::widen<DoubleDouble>(normal_now);
  const Vector2<double> now_unit = rounded_unit(n);
  if (by == TravelsWith::a) return apart_of_units(now_unit, rounded_unit(by_a));
  if (by == TravelsWith::b) return apart_of_units(now_unit, rounded_unit(by_b));
  const double turn = cross(by_a, by_b).high;
  const double from_a = cross(by_a, n).high;
  const double to_b = cross(n, by_b).high;
  const bool is_between = turn > 0 ? from_a >= 0 && to_b >= 0 : from_a <= 0 && to_b <= 0;
  if (turn != 0 && is_between) return 0;
  return std::min(apart_of_units(now_unit, rounded_unit(by_a)),
                  apart_of_units(now_unit, rounded_unit(by_b)));
}

double turned_since(const PairCase& then, const PairCase& now) {
  const FinePoint x{DoubleDouble(1), DoubleDouble(0)};
  const FinePoint by_a = carried_by(then, now, Side::a, x);
  const FinePoint by_b = carried_by(then, now, Side::b, x);
  return std::abs(std::atan2(cross(by_a, by_b).high, dot(by_a, by_b).high));
}

}  // namespace manifuzz
