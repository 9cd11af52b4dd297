#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "exact/placed.hpp"
#include "report/round_truth.hpp"
#include "report/upstream/parts.hpp"

namespace manifuzz {
namespace {

/// How far a place lies out of a core: of one with mitred corners the greatest distance in front of
/// a face; negative or 0 within.
double outside_core(const exact::RoughPolygon& core, const Vector2<double>& place, bool is_mitred) {
  double in_front = -INFINITY;
  double nearest = INFINITY;
  for (int i = 0; i < core.count; ++i) {
    const Vector2<double>& from = core.vertices[i];
    in_front = std::max(in_front, core.normals[i].dot(place - from));
    nearest =
        std::min(nearest, exact::distance_to_segment(place, from, core.vertices[core.next(i)]));
  }
  const bool is_inside = core.count > 2 && in_front <= 0;
  return is_inside || is_mitred ? in_front : nearest;
}

std::span<const ContactPoint<double>> points_of(const Manifold<double>& manifold) {
  return std::span(manifold.points).first(std::clamp(manifold.count, 0, 2));
}

PointErrors errors_against(const Manifold<double>& given, const Manifold<double>& right) {
  PointErrors worst;
  for (const auto& [place, depth, features] : points_of(given)) {
    PointErrors nearest{INFINITY, INFINITY};
    for (const auto& [right_place, right_depth, right_features] : points_of(right)) {
      const PointErrors one{(place - right_place).norm(), std::abs(depth - right_depth)};
      if (one.place < nearest.place) nearest = one;
    }
    worst.place = std::max(worst.place, nearest.place);
    worst.depth = std::max(worst.depth, nearest.depth);
  }
  return worst;
}

}  // namespace

double outside_by(const PairCase& pair, const DeclaredAnswer& asked) {
  const Manifold<double>* const given = manifold_in(asked.answer);
  if (given == nullptr) return 0;
  const exact::RoughPair placed = exact::place_roughly(pair);
  const Vector2<double> origin = pair.a.pose.position.cast<double>();
  double outside = 0;
  for (const auto& point : points_of(*given)) {
    const Vector2<double> place = to_world(pair, point.position) - origin;
    for (const Side side : {Side::a, Side::b}) {
      const bool is_mitred = pair[side].polygon.radius > 0 && !is_round(pair);
      outside = std::max(outside, outside_core(placed[side], place, is_mitred) -
                                      static_cast<double>(pair[side].polygon.radius));
    }
  }
  return outside;
}

PointErrors point_errors(const PairCase& pair, const DeclaredAnswer& asked) {
  const Manifold<double>* const given = manifold_in(asked.answer);
  std::optional<PointErrors> least;
  if (given == nullptr) return {};
  for (const Manifold<double>& right :
       manifolds_to_show(admissible(pair, asked.declaration), asked.declaration)) {
    if (right.count == 0) continue;
    const PointErrors errors = errors_against(*given, right);
    if (!least || errors.place < least->place) least = errors;
  }
  return least.value_or(PointErrors{});
}

double span_of(const Manifold<double>& manifold) {
  if (manifold.count < 2) return 0;
  return (manifold.points[0].position - manifold.points[1].position).norm();
}

double turn_of(const PairCase& pair, const Vector2<double>& normal,
               const Declaration& declaration) {
  double turn = std::numbers::pi;
  for (const Manifold<double>& right :
       manifolds_to_show(admissible(pair, declaration), declaration)) {
    if (right.count == 0) continue;
    turn = std::min(turn, exact::angle_between(right.normal, normal));
  }
  return turn;
}

Kind told_kind(const JudgedCase& judged, const DeclaredAnswer& asked) {
  const Kind kind = judged.judgement.bucket.kind;
  const PairCase& pair = judged.given.pair();
  const bool are_in_place = kind == Kind::position && point_errors(pair, asked).place <=
                                                          bounds(pair, asked.declaration).position;
  return are_in_place ? Kind::count : kind;
}

}  // namespace manifuzz
