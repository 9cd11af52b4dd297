#include <cmath>
#include <numbers>

#include "mistakes.hpp"

namespace manifuzz::mistakes {
namespace {

Declaration separation() {
  return of(Claims::separation);
}
Declaration made_in_float() {
  Declaration declaration = separation();
  declaration.scalar = ScalarType::float32;
  return declaration;
}
Declaration touching() {
  return of(Claims::touching);
}
Declaration biased() {
  Declaration declaration = separation();
  declaration.tie_bias.absolute = 1e9;
  return declaration;
}
Declaration biased_to_b() {
  Declaration declaration = biased();
  declaration.tie_bias = {.absolute = 0, .relative = 0.5, .towards = Side::b};
  return declaration;
}
Declaration tolerant() {
  Declaration declaration = separation();
  declaration.tolerance.relative = 0.01;
  return declaration;
}

Given reversed(const Right& right, const Declaration& by) {
  if (!right.can_be_reversed(by)) return std::nullopt;
  return right.along(-right.normal, right.depth);
}

/// The first face of that side, not the best one, that is clearly deeper than the least.
std::optional<Vector2<double>> deeper_face(const Right& right, Side side, const Declaration& by) {
  for (int i = 0; i < right.pair()[side].polygon.face_count(); ++i) {
    const exact::FaceOf face{side, i};
    if (face == right.truth->greatest(side)) continue;
    const auto n = exact::true_normal<exact::Approximate<double>>(right.pair(), face);
    const Vector2<double> normal(n.x.value, n.y.value);
    if (right.is_clear(right.at(normal) - right.depth, by)) return normal;
  }
  return std::nullopt;
}

Given along_other(const Right& right, const Vector2<double>& normal, const Declaration& by) {
  if (!right.is_clear(right.at(normal) - right.depth, by)) return std::nullopt;
  return right.along(normal, right.at(normal));
}

/// A face normal of the best face of that side, where the other side's is clearly less deep.
Given best_of(const Right& right, Side side, const Declaration& by) {
  if (right.pair()[side].polygon.face_count() == 0) return std::nullopt;
  const auto n =
      exact::true_normal<exact::Approximate<double>>(right.pair(), right.truth->greatest(side));
  return along_other(right, {n.x.value, n.y.value}, by);
}

}  // namespace

std::vector<Mistake> of_separations() {
  return {
      {"a reversed normal", separation, reversed, {Kind::reversed}},
      {"a reversed normal, in float", made_in_float, reversed, {Kind::reversed}},
      {"a normal on a grid of 18 degrees",
       separation,
       [](const Right& r, const Declaration& by) {
         const double step = std::numbers::pi / 10;
         const double angle = std::atan2(r.normal.y(), r.normal.x());
         return along_other(r, turned({1, 0}, step * std::round(angle / step)), by);
       },
       {Kind::not_minimal},
       {Kind::inconsistent, Kind::not_minimal}},
      {"a normal turned by a thousandth, its depth that of the right one",
       separation,
       [](const Right& r, const Declaration& by) -> Given {
         const Vector2<double> normal = turned(r.normal, 1e-3);
         if (!r.is_clear(r.at(normal) - r.depth, by)) return std::nullopt;
         return r.along(normal, r.depth);
       },
       {Kind::inconsistent, Kind::not_minimal},
       {Kind::not_minimal}},
      {"the direction between the origins",
       separation,
       [](const Right& r, const Declaration& by) -> Given {
         const Vector2<double> apart =
             r.pair().b.pose.position.cast<double>() - r.pair().a.pose.position.cast<double>();
         if (apart.isZero(0)) return std::nullopt;
         return along_other(r, local_normal(r.pair(), apart / apart.stableNorm()), by);
       },
       {Kind::not_minimal},
       {Kind::inconsistent, Kind::not_minimal}},
      {"the tangent",
       separation,
       [](const Right& r, const Declaration& by) {
         return along_other(r, turned(r.normal, std::numbers::pi / 2), by);
       },
       {Kind::not_minimal},
       {Kind::inconsistent, Kind::not_minimal}},
      {"the depth of another face",
       separation,
       [](const Right& r, const Declaration& by) -> Given {
         const auto other = deeper_face(r, Side::a, by);
         return other ? Given(r.along(r.normal, r.at(*other))) : std::nullopt;
       },
       {Kind::inconsistent}},
      {"ten bounds too deep",
       separation,
       [](const Right& r, const Declaration& by) -> Given {
         return r.along(r.normal, r.depth + kClearly * r.bounds(by).consistency);
       },
       {Kind::inconsistent}},
      {"ten bounds too shallow",
       separation,
       [](const Right& r, const Declaration& by) -> Given {
         return r.along(r.normal, r.depth - kClearly * r.bounds(by).consistency);
       },
       {Kind::inconsistent}},
      {"half the depth",
       separation,
       [](const Right& r, const Declaration&) -> Given { return r.along(r.normal, r.depth / 2); },
       {Kind::inconsistent}},
      {"the depth without the radii",
       separation,
       [](const Right& r, const Declaration& by) -> Given {
         const double radii = total_radius(r.pair());
         if (!r.is_clear(radii, by) || !(r.depth > 2 * radii)) return std::nullopt;
         return r.along(r.normal, r.depth - radii);
       },
       {Kind::inconsistent},
       {},
       std::nullopt},
      {"a normal 1% too long",
       separation,
       [](const Right& r, const Declaration&) -> Given {
         return r.along(1.01 * r.normal, r.depth);
       },
       {Kind::normal}},
      {"a normal of no length",
       separation,
       [](const Right& r, const Declaration&) -> Given {
         return r.along(Vector2<double>(0, 0), r.depth);
       },
       {Kind::normal}},
      {"a deeper face of A under a bias towards A",
       biased,
       [](const Right& r, const Declaration& by) -> Given {
         const auto other = deeper_face(r, Side::a, by);
         if (!other || r.pair().b.polygon.face_count() == 0) return std::nullopt;
         const auto best = r.truth->greatest(Side::a);
         if (r.truth->compare_separations(best, r.truth->greatest(Side::b), 0) < 0) {
           return std::nullopt;
         }
         return along_other(r, *other, by);
       },
       {Kind::not_minimal},
       {Kind::inconsistent, Kind::not_minimal}},
      {"B's best face under a bias towards A, though A's is less deep",
       biased,
       [](const Right& r, const Declaration& by) { return best_of(r, Side::b, by); },
       {Kind::not_minimal},
       {Kind::inconsistent, Kind::not_minimal}},
      {"A's best face under a bias towards B, though B's is less deep",
       biased_to_b,
       [](const Right& r, const Declaration& by) { return best_of(r, Side::a, by); },
       {Kind::not_minimal},
       {Kind::inconsistent, Kind::not_minimal}},
      {"too deep by half of a tolerance",
       tolerant,
       [](const Right& r, const Declaration& by) -> Given {
         return r.along(r.normal, 1.005 * r.depth + kClearly * r.bounds(by).consistency);
       },
       {Kind::inconsistent}},
      {"an excess of three tolerances",
       tolerant,
       [](const Right& r, const Declaration& by) -> Given {
         for (double angle = 1e-3; angle < 1; angle *= 1.5) {
           const Vector2<double> normal = turned(r.normal, angle);
           if (r.at(normal) > 1.03 * r.depth + kClearly * r.bounds(by).minimality) {
             return r.along(normal, r.at(normal));
           }
         }
         return std::nullopt;
       },
       {Kind::not_minimal},
       {Kind::inconsistent, Kind::not_minimal}},
      {"no contact for an overlap, with a normal",
       separation,
       [](const Right&, const Declaration&) -> Given { return Penetration{}; },
       {Kind::missed_contact}},
      {"no contact for an overlap",
       touching,
       [](const Right&, const Declaration&) -> Given { return Penetration{}; },
       {Kind::missed_contact}}};
}

}  // namespace manifuzz::mistakes
