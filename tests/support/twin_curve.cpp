#include "support/twin_curve.hpp"

#include <algorithm>
#include <functional>

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

/// What must not be negative at a line's place.
using Condition = std::function<Ratio(const Ratio& place)>;

bool holds(const std::vector<Condition>& conditions, const Ratio& place) {
  return std::ranges::all_of(conditions, [&](const Condition& c) { return c(place) >= 0; });
}

/// Each condition is linear between two of the places that follow each other: where all hold, they
/// do so at one of them, or where one turns.
bool hold_somewhere(const std::vector<Condition>& conditions, const std::vector<Ratio>& places) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (holds(conditions, places[i])) return true;
    if (i + 1 == places.size()) break;
    const Ratio& from = places[i];
    const Ratio run = places[i + 1] - from;
    for (const Condition& condition : conditions) {
      const Ratio first = condition(from);
      const Ratio last = condition(places[i + 1]);
      if ((first < 0) == (last < 0)) continue;
      if (holds(conditions, from + run * first / (first - last))) return true;
    }
  }
  return false;
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
  const Exact tangent{-direction.y, direction.x};
  const Ratio length = *square_root(direction * direction).rational();
  const Exact at = turned(claim.position);
  const Ratio depth = *(along(direction) * Real(length)).rational();
  const auto top = [&](const Ratio& place) { return *height(a_, direction, place, 1); };
  const auto bottom = [&](const Ratio& place) { return *height(b_, direction, place, -1); };
  const Condition gap = [&](const Ratio& place) -> Ratio {
    return top(place) - bottom(place) + radius_ * length;
  };
  const auto within = [&](double bound) -> Ratio { return Ratio(bound) * length; };

  std::vector<Ratio> places;
  for (const Outline* polygon : {&a_, &b_}) {
    for (const Exact& corner : polygon->corners) {
      const Ratio place = tangent * corner;
      if (height(a_, direction, place, 1) && height(b_, direction, place, -1)) {
        places.push_back(place);
      }
    }
  }
  std::ranges::sort(places);
  for (const exact::Height& claimed : claim.heights) {
    const Condition off = [&](const Ratio& place) -> Ratio {
      return Ratio(claimed.of_top) * top(place) + Ratio(claimed.of_bottom) * bottom(place) +
             within(claimed.offset) - direction * at;
    };
    std::vector<Condition> conditions{
        [&](const Ratio& p) -> Ratio { return p - tangent * at + within(claim.along); },
        [&](const Ratio& p) -> Ratio { return tangent * at + within(claim.along) - p; },
        [&](const Ratio& p) -> Ratio { return within(claim.across) + off(p); },
        [&](const Ratio& p) -> Ratio { return within(claim.across) - off(p); },
        [&](const Ratio& p) -> Ratio {
          return gap(p) - within(claim.gap_least) + within(claim.slack);
        },
        [&](const Ratio& p) -> Ratio {
          return within(claim.gap_most) + within(claim.slack) - gap(p);
        }};
    if (claim.shortfall) {
      conditions.emplace_back(
          [&](const Ratio& p) -> Ratio { return gap(p) - depth + within(*claim.shortfall); });
    }
    if (hold_somewhere(conditions, places)) return true;
  }
  return false;
}

}  // namespace manifuzz::twin
