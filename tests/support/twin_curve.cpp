#include "support/twin_curve.hpp"

#include <algorithm>

namespace manifuzz::twin {
namespace {

Exact negative(const Exact& v) {
  return {-v.x, -v.y};
}

/// The largest, or with `sign` -1 the smallest, height of a polygon on a line along the direction:
/// times the direction's length, as the line's place is. None where the line misses it.
std::optional<Ratio> height(const Outline& polygon, const Exact& direction, const Ratio& place,
                            int sign) {
  const Exact tangent{-direction.y, direction.x};
  std::optional<Ratio> most;
  const auto consider = [&](const Ratio& found) {
    if (!most || sign * found > sign * *most) most = found;
  };
  for (int i = 0; i < polygon.size(); ++i) {
    const Ratio from = tangent * polygon.corner(i);
    const Ratio to = tangent * polygon.corner(i + 1);
    const Ratio height_from = direction * polygon.corner(i);
    const Ratio height_to = direction * polygon.corner(i + 1);
    if (from == place) consider(height_from);
    if (to == place) consider(height_to);
    if ((from < place && place < to) || (to < place && place < from)) {
      const Ratio share = (place - from) / (to - from);
      consider(height_from + share * (height_to - height_from));
    }
  }
  return most;
}

/// From A to B.
std::vector<Exact> face_normals(const Outline& polygon, Side side) {
  std::vector<Exact> normals;
  for (int i = 0; i < polygon.size(); ++i) {
    normals.push_back(side == Side::a ? polygon.normal(i) : negative(polygon.normal(i)));
  }
  return normals;
}

}  // namespace

TwinCurve::TwinCurve(const PairCase& pair, bool is_round)
    : turn_of_a_(exact(pair.a.pose.rotation)),
      a_(outline(pair.a, exact(pair.a.pose.position))),
      b_(outline(pair.b, exact(pair.a.pose.position))),
      radius_(Ratio(static_cast<double>(pair.a.polygon.radius)) +
              Ratio(static_cast<double>(pair.b.polygon.radius))),
      least_(lesser(least_of(Side::a), least_of(Side::b))) {
  if (!is_round || !(least_ < Real(radius_))) return;
  std::vector<Exact> directions;
  for (const Exact& of_a : a_.corners) {
    for (const Exact& of_b : b_.corners) {
      const Exact between = of_b - of_a;
      if (between * between > 0) directions.push_back(between);
    }
  }
  least_ = lesser(least_, least_of(directions));
}

Real TwinCurve::least_of(Side side) const {
  return least_of(face_normals(side == Side::a ? a_ : b_, side));
}

Exact TwinCurve::turned(const Vector2<double>& normal) const {
  const Ratio x(normal.x());
  const Ratio y(normal.y());
  return {turn_of_a_.x * x - turn_of_a_.y * y, turn_of_a_.y * x + turn_of_a_.x * y};
}

Real TwinCurve::along(const Exact& direction) const {
  Ratio most = direction * (a_.corner(0) - b_.corner(0));
  for (const Exact& of_a : a_.corners) {
    for (const Exact& of_b : b_.corners) {
      most = std::max<Ratio>(most, direction * (of_a - of_b));
    }
  }
  return Real(most) / square_root(direction * direction) + Real(radius_);
}

Real TwinCurve::least_of(const std::vector<Exact>& directions) const {
  Real least = along(directions.front());
  for (const Exact& direction : directions) least = lesser(least, along(direction));
  return least;
}

std::optional<Real> TwinCurve::gap(const Vector2<double>& normal) const {
  const Exact direction = turned(normal);
  std::optional<Ratio> most;
  for (const Outline* polygon : {&a_, &b_}) {
    for (const Exact& corner : polygon->corners) {
      const Ratio place = Exact{-direction.y, direction.x} * corner;
      const auto top = height(a_, direction, place, 1);
      const auto bottom = height(b_, direction, place, -1);
      if (top && bottom && (!most || *top - *bottom > *most)) most = *top - *bottom;
    }
  }
  if (!most) return std::nullopt;
  return Real(*most) / square_root(direction * direction) + Real(radius_);
}

}  // namespace manifuzz::twin
