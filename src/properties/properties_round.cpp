#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geometry/pair_case.hpp"
#include "properties/round_answer.hpp"

namespace manifuzz {
namespace {

constexpr int kCorners = 8;  // of the polygons around a circle: the most that a shape may have

Vector2<double> in_world(const Body& body, const Vector2<double>& local) {
  return transform<double>({body.pose.position.cast<double>(), body.pose.rotation.cast<double>()},
                           local);
}

/// How long a body's unit of length is in the world: its rotation is not quite unit.
double scale_of(const Body& body) {
  const Vector2<double> rotation = body.pose.rotation.cast<double>();
  return std::sqrt(rotation.dot(rotation));
}

/// By how much two intervals of the least depth are apart where `inner` is that of a shape within
/// the other's, which reaches at most `reach` beyond it; at most 0 where that may be.
double contradiction(const RoundAnswer& inner, const RoundAnswer& outer, double reach) {
  return std::max(inner.least() - outer.most(), outer.least() - inner.most() - reach);
}

/// What holds where one is within the other, `rounding` apart: a contradiction of at most 0.
PropertyOutcome holds_within(const RoundAnswer& inner, const RoundAnswer& outer, double rounding,
                             double off) {
  return holds(taken_within(inner.half_width() + outer.half_width() + rounding, off));
}

/// The circle around a capsule's core at a place of its frame.
ConvexPolygon<float> circle_at(const Vector2<float>& place, float radius) {
  const std::array<Vector2<float>, 1> center{place};
  return make_polygon<float>(center, radius);
}

/// The place of a segment's core, in the world, that is nearest to the other core's outline.
Vector2<double> nearest_to_outline(const exact::RoughPolygon& segment,
                                   const exact::RoughPolygon& other) {
  const Vector2<double>& from = segment.vertices[0];
  const Vector2<double>& to = segment.vertices[1];
  Vector2<double> best = from;
  double least = INFINITY;
  const auto take = [&](const Vector2<double>& place, const Vector2<double>& opposite) {
    const double apart = (place - opposite).norm();
    if (apart < least) {
      least = apart;
      best = place;
    }
  };
  for (int i = 0; i < other.count; ++i) {
    const Vector2<double>& corner = other.vertices[i];
    take(exact::nearest_on_segment(corner, from, to), corner);
    for (const Vector2<double>& end : {from, to}) {
      take(end, exact::nearest_on_segment(end, corner, other.vertices[other.next(i)]));
    }
  }
  return best;
}

/// A pair with a capsule replaced by the circle at the place that is nearest to the other core.
PairCase with_nearest_circle(const PairCase& pair, Side side) {
  const exact::RoughPair placed = exact::place_roughly(pair);
  const Vector2<double> place = nearest_to_outline(placed[side], placed[other(side)]);
  const Body& body = pair[side];
  const Vector2<double> apart =
      pair[side].pose.position.cast<double>() - pair.a.pose.position.cast<double>();
  const Vector2<double> local =
      rotate_inverse<double>(body.pose.rotation.cast<double>(), place - apart);
  PairCase smaller = pair;
  smaller[side].polygon = circle_at(local.cast<float>(), body.polygon.radius);
  return smaller;
}

/// How far the circle's center lies off the capsule's core, a world length.
double off_core(const PairCase& pair, const PairCase& smaller, Side side) {
  const auto end = [&](int i) { return pair[side].polygon.vertices[i].cast<double>(); };
  const Vector2<double> center = smaller[side].polygon.vertices[0].cast<double>();
  const Vector2<double> apart = center - exact::nearest_on_segment(center, end(0), end(1));
  return apart.norm() * scale_of(pair[side]);
}

/// A regular polygon about a circle's center, its corners so far from it; how far the farthest of
/// them is off that place by rounding.
struct Around {
  ConvexPolygon<float> polygon;
  double rounding = 0;
};

std::optional<Around> polygon_around(const ConvexPolygon<float>& circle, double reach) {
  Around around;
  std::array<Vector2<float>, kCorners> corners;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.5) / kCorners;
    const Vector2<double> at = circle.vertices[0].cast<double>() +
                               reach * Vector2<double>(std::cos(angle), std::sin(angle));
    corners[i] = at.cast<float>();
    around.rounding = std::max(around.rounding, (corners[i].cast<double>() - at).norm());
  }
  if (find_shape_defect(corners, 0)) return std::nullopt;
  around.polygon = make_polygon<float>(corners, 0, Rounding::round);
  return around;
}

/// The pair with a circle replaced by a polygon that reaches so far from its center; the answer to
/// it held against the circle's: `inner_of` the polygon is within the circle, or around it.
PropertyOutcome polygon_beside_circle(AskedCollider& ask, const PairCase& pair, Side side,
                                      const RoundAnswer& of_circle, double reach, bool is_inside) {
  const ConvexPolygon<float>& circle = pair[side].polygon;
  const auto around = polygon_around(circle, reach);
  if (!around) return not_applicable();
  PairCase with_polygon = pair;
  with_polygon[side].polygon = around->polygon;
  const RoundAnswer of_polygon(ask, with_polygon);
  if (!of_polygon.is_given()) return not_applicable();
  // Corners and faces are off by no more than the corners' rounding, either way; and a rotation
  // that is not quite unit scales them, and no radius.
  const double share = std::cos(std::numbers::pi / kCorners);
  const double scale = scale_of(pair[side]);
  const double rounding = around->rounding * scale + std::abs(scale - 1) * reach;
  const double between = reach * (1 - share);
  const RoundAnswer& inner = is_inside ? of_polygon : of_circle;
  const RoundAnswer& outer = is_inside ? of_circle : of_polygon;
  const double off = contradiction(inner, outer, between) - rounding;
  if (off <= 0) return holds_within(inner, outer, rounding, off);
  return fails(is_inside ? "an inscribed polygon too deep, or too shallow"
                         : "a circumscribed polygon too deep, or too shallow",
               off / size(pair));
}

std::optional<Side> side_with(const PairCase& pair, int vertices) {
  for (const Side side : {Side::a, Side::b}) {
    if (pair[side].polygon.count == vertices) return side;
  }
  return std::nullopt;
}

}  // namespace

PropertyOutcome circles_may_turn(AskedCollider& ask, const PairCase& pair) {
  const auto side = side_with(pair, 1);
  if (!side) return not_applicable();
  // A quarter turn and one of 3, 4 and 5, about the center: the position takes what that moves.
  const Vector2<double> start =
      in_world(pair[*side], pair[*side].polygon.vertices[0].cast<double>());
  double of_bound = 0;
  for (const Vector2<float>& turn : {Vector2<float>(0, 1), Vector2<float>(0.6F, -0.8F)}) {
    PairCase turned = pair;
    Body& body = turned[*side];
    body.pose.rotation = rotate(turn, body.pose.rotation);
    const Vector2<double> center = body.polygon.vertices[0].cast<double>();
    const Vector2<double> moved_by = rotate<double>(body.pose.rotation.cast<double>(), center);
    body.pose.position = Vector2<double>(start - moved_by).cast<float>();
    const double shift = (in_world(body, center) - start).norm();
    const RoundAnswer before(ask, pair);
    const RoundAnswer after(ask, turned);
    if (!before.is_given() || !after.is_given()) return not_applicable();
    const double apart =
        std::max(before.least() - after.most(), after.least() - before.most()) - shift;
    if (!(apart <= 0)) return fails("another depth when turned", apart / size(pair));
    of_bound = std::max(of_bound, taken_within(before.half_width() + after.half_width(), apart));
    if (!before.tells_normal() || !after.tells_normal()) continue;
    const double off = (world_normal(pair, before.manifold().normal) -
                        world_normal(turned, after.manifold().normal))
                           .norm();
    const double seen = shift / std::min(before.distance(), after.distance());
    const double bound = before.normal_bound() + after.normal_bound() + seen;
    if (!(off <= bound)) return fails("another normal when turned", off);
    of_bound = std::max(of_bound, taken_of(bound - seen, off - seen));
  }
  return holds(of_bound);
}

PropertyOutcome capsules_are_hulls_of_circles(AskedCollider& ask, const PairCase& pair) {
  const auto side = side_with(pair, 2);
  if (!side || !(pair[*side].polygon.radius > 0)) return not_applicable();
  const RoundAnswer of_capsule(ask, pair);
  if (!of_capsule.is_given()) return not_applicable();
  const auto hold_against = [&](const PairCase& smaller, double reach) {
    const RoundAnswer of_circle(ask, smaller);
    if (!of_circle.is_given()) return not_applicable();
    const double rounding = off_core(pair, smaller, *side);
    const double off = contradiction(of_circle, of_capsule, reach) - rounding;
    if (off <= 0) return holds_within(of_circle, of_capsule, rounding, off);
    return fails("a circle within a capsule too deep, or none as deep", off / size(pair));
  };
  const ConvexPolygon<float>& capsule = pair[*side].polygon;
  double of_bound = 0;
  for (int end = 0; end < 2; ++end) {
    PairCase smaller = pair;
    smaller[*side].polygon = circle_at(capsule.vertices[end], capsule.radius);
    const PropertyOutcome outcome = hold_against(smaller, INFINITY);
    if (outcome.kind != PropertyOutcome::Kind::holds) return outcome;
    of_bound = std::max(of_bound, outcome.of_bound);
  }
  // Where cores are apart, the nearest circle is as deep; a circle is rounded to floats.
  const bool are_apart = of_capsule.curve().are_cores_apart();
  const PairCase smaller = with_nearest_circle(pair, *side);
  const Vector2<double> center = smaller[*side].polygon.vertices[0].cast<double>();
  const double rounding = 2 * roundoff(ScalarType::float32) * center.norm() * scale_of(pair[*side]);
  PropertyOutcome outcome = hold_against(smaller, are_apart ? rounding : INFINITY);
  outcome.of_bound = std::max(of_bound, outcome.of_bound);
  return outcome;
}

PropertyOutcome circles_are_limits_of_polygons(AskedCollider& ask, const PairCase& pair) {
  const auto side = side_with(pair, 1);
  if (!side || !ask.declaration().takes_round) return not_applicable();
  const RoundAnswer of_circle(ask, pair);
  if (!of_circle.is_given()) return not_applicable();
  const double radius = static_cast<double>(pair[*side].polygon.radius);
  const double share = std::cos(std::numbers::pi / kCorners);
  const PropertyOutcome inscribed =
      polygon_beside_circle(ask, pair, *side, of_circle, radius, true);
  if (inscribed.kind != PropertyOutcome::Kind::holds) return inscribed;
  PropertyOutcome around =
      polygon_beside_circle(ask, pair, *side, of_circle, radius / share, false);
  around.of_bound = std::max(around.of_bound, inscribed.of_bound);
  return around;
}

}  // namespace manifuzz
