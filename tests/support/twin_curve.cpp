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

/// What must not be negative: x top + y bottom + constant.
struct Condition {
  Ratio x;
  Ratio y;
  Ratio constant;

  Ratio at(const Ratio& top, const Ratio& bottom) const { return x * top + y * bottom + constant; }
};

/// Whether all hold somewhere, of conditions that bound both: then they hold where two are zero.
bool hold_somewhere(const std::vector<Condition>& conditions) {
  for (const Condition& p : conditions) {
    for (const Condition& q : conditions) {
      const Ratio turn = p.x * q.y - p.y * q.x;
      if (turn == 0) continue;
      const Ratio top = (p.y * q.constant - q.y * p.constant) / turn;
      const Ratio bottom = (q.x * p.constant - p.x * q.constant) / turn;
      if (std::ranges::all_of(conditions,
                              [&](const Condition& c) { return c.at(top, bottom) >= 0; })) {
        return true;
      }
    }
  }
  return false;
}

/// The least and the largest height of a polygon on lines along the direction, from one place to
/// another: at one of them, or at a corner between, whichever way it faces on a narrow one.
std::optional<std::pair<Ratio, Ratio>> heights(const Outline& polygon, const Exact& direction,
                                               const Ratio& from, const Ratio& to, int sign,
                                               const Ratio& narrow) {
  const Exact tangent{-direction.y, direction.x};
  std::vector<Ratio> places;
  for (const Exact& corner : polygon.corners) places.push_back(tangent * corner);
  const bool is_narrow = std::ranges::max(places) - std::ranges::min(places) <= narrow;
  std::vector<Ratio> found;
  const auto look = [&](const Ratio& place) {
    if (const auto seen = height(polygon, direction, place, sign)) found.push_back(*seen);
  };
  look(from);
  look(to);
  for (const Exact& corner : polygon.corners) {
    const Ratio place = tangent * corner;
    if (place < from || to < place) continue;
    look(place);
    if (is_narrow) found.push_back(direction * corner);
  }
  if (found.empty()) return std::nullopt;
  return std::pair(std::ranges::min(found), std::ranges::max(found));
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

bool TwinCurve::has_witness(const Vector2<double>& normal, const exact::PointClaim& claim) const {
  const Exact direction = turned(normal);
  const Ratio length = *square_root(direction * direction).rational();
  const Exact at = turned(claim.position);
  const Ratio place = Exact{-direction.y, direction.x} * at;
  const auto scaled = [&](double world) -> Ratio { return Ratio(world) * length; };
  const Ratio near = scaled(claim.along);
  if (near < 0) return false;
  const Ratio narrow = scaled(claim.narrow);
  const auto top = heights(a_, direction, place - near, place + near, 1, narrow);
  const auto bottom = heights(b_, direction, place - near, place + near, -1, narrow);
  if (!top || !bottom) return false;
  const Ratio radii = radius_ * length;
  std::vector<Condition> common{{1, 0, -top->first},
                                {-1, 0, top->second},
                                {0, 1, -bottom->first},
                                {0, -1, bottom->second},
                                {1, -1, radii - scaled(claim.gap_least) + scaled(claim.slack)},
                                {-1, 1, scaled(claim.gap_most) + scaled(claim.slack) - radii}};
  if (claim.shortfall) {
    const Ratio depth = *(along(direction) * Real(length)).rational();
    common.push_back({1, -1, radii - depth + scaled(*claim.shortfall)});
  }
  return std::ranges::any_of(claim.heights, [&](const exact::Height& claimed) {
    std::vector<Condition> all = common;
    const Ratio off = scaled(claimed.offset) - direction * at;
    const Ratio across = scaled(claim.across);
    all.push_back({claimed.of_top, claimed.of_bottom, across + off});
    all.push_back({-claimed.of_top, -claimed.of_bottom, across - off});
    return hold_somewhere(all);
  });
}

std::optional<Real> TwinCurve::most_gap(const Vector2<double>& normal, double slide) const {
  const Exact direction = turned(normal);
  const Exact tangent{-direction.y, direction.x};
  const Ratio length = *square_root(direction * direction).rational();
  const Ratio off = Ratio(slide) * length;
  std::optional<Ratio> most;
  const auto consider = [&](const Ratio& place_a, const Ratio& place_b) {
    if (place_a - place_b > off || place_b - place_a > off) return;
    const auto top = height(a_, direction, place_a, 1);
    const auto bottom = height(b_, direction, place_b, -1);
    if (top && bottom && (!most || *top - *bottom > *most)) most = *top - *bottom;
  };
  for (const Exact& of_a : a_.corners) {
    for (const Exact& of_b : b_.corners) {
      const Ratio a = tangent * of_a;
      const Ratio b = tangent * of_b;
      consider(a, b);
      for (const Ratio& moved : {Ratio(0), off, Ratio(-off)}) {
        consider(a, a + moved);
        consider(b + moved, b);
      }
    }
  }
  if (!most) return std::nullopt;
  return Real(Ratio(*most / length + radius_));
}

std::optional<Real> TwinCurve::least_gap(const Vector2<double>& normal, double slide) const {
  const Exact direction = turned(normal);
  const Exact tangent{-direction.y, direction.x};
  const Ratio length = *square_root(direction * direction).rational();
  std::optional<Real> least;
  for (const double moved : {slide, -slide}) {
    const Ratio off = Ratio(moved) * length;
    std::optional<Ratio> most;
    const auto consider = [&](const Ratio& place) {
      const auto top = height(a_, direction, place, 1);
      const auto bottom = height(b_, direction, place + off, -1);
      if (top && bottom && (!most || *top - *bottom > *most)) most = *top - *bottom;
    };
    for (const Exact& corner : a_.corners) consider(tangent * corner);
    for (const Exact& corner : b_.corners) consider(tangent * corner - off);
    if (!most) return std::nullopt;
    const Real found = Ratio(*most / length + radius_);
    least = least ? lesser(*least, found) : found;
  }
  return least;
}

}  // namespace manifuzz::twin
