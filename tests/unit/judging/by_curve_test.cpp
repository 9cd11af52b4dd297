#include "judging/by_curve.hpp"

#include <cmath>
#include <string>

#include <catch2/catch.hpp>

#include "exchange/json.hpp"
#include "generating/regime.hpp"
#include "own_colliders/own_colliders.hpp"

using namespace manifuzz;

namespace {

constexpr std::uint64_t kCases = 150;  // of each regime

/// The pairs of all regimes that overlap by clearly more than rounding.
template <class Check>
void for_overlapping(const Check& check) {
  for (const Regime& regime : regimes()) {
    for (std::uint64_t i = 0; i < kCases; ++i) {
      const PairCase pair = generate(19, regime, i, {.corpus = {}, .radius = 0});
      const exact::Truth truth(pair);
      const Declaration declaration = make_clip().declaration;
      const Bounds bound = bounds(pair, declaration, truth.extent());
      if (is_ill_posed(truth.size(), bound)) continue;
      if (truth.separation() > -20 * bound.separation) continue;
      std::string line;
      append_case_line(line, pair);
      INFO(regime.name << ", index " << i << "\n" << line);
      check(truth, bound);
    }
  }
}

Declaration without_clips(Declaration declaration, PointsAt points = PointsAt::clip) {
  declaration.clips = false;
  declaration.points = points;
  return declaration;
}

Declaration separating(ScalarType scalar) {
  Declaration declaration;
  declaration.scalar = scalar;
  declaration.claims = Claims::separation;
  return declaration;
}

Penetration least_penetration(const exact::Truth& truth) {
  const exact::PenetrationCurve curve(truth, exact::Skin::mitred);
  return {true, curve.minima(0).front(), curve.least()};
}

Kind kind_of(const exact::Truth& truth, const Declaration& declaration, const Answer& answer) {
  return judge_by_curve(truth, declaration, answer).kind;
}

Manifold<double> clipped(const PairCase& pair, const Collider& collider) {
  return std::get<Manifold<double>>(collider.collide(pair));
}

Manifold<double> at_midpoints(const PairCase& pair, Manifold<double> manifold) {
  const double unit = pair.a.pose.rotation.cast<double>().norm();
  for (int i = 0; i < manifold.count; ++i) {
    ContactPoint<double>& point = manifold.points[i];
    const double towards_a = manifold.reference == Side::a ? 0.5 : -0.5;
    point.position += towards_a * point.depth / unit * manifold.normal;
  }
  return manifold;
}

/// A normal turned to the next of ten directions a half turn.
Vector2<double> on_grid(const Vector2<double>& normal) {
  const double step = std::acos(-1) / 10;
  const double angle = step * std::round(std::atan2(normal.y(), normal.x()) / step);
  return {std::cos(angle), std::sin(angle)};
}

}  // namespace

TEST_CASE("the least depth along its normal is right, to the last digit of double") {
  for_overlapping([](const exact::Truth& truth, const Bounds&) {
    const CurveJudgement judged =
        judge_by_curve(truth, separating(ScalarType::float64), least_penetration(truth));
    REQUIRE(judged.kind == Kind::none);
    REQUIRE(judged.consistent == true);
    REQUIRE(judged.minimal == true);
    REQUIRE(!judged.witness.has_value());
  });
}

TEST_CASE("what clips find is right where no clip is claimed, as clip points and as midpoints") {
  for_overlapping([](const exact::Truth& truth, const Bounds&) {
    for (const Collider& collider : {make_clip(), make_clip64()}) {
      INFO(collider.declaration.name);
      const Manifold<double> manifold = clipped(truth.pair(), collider);
      const CurveJudgement judged =
          judge_by_curve(truth, without_clips(collider.declaration), manifold);
      REQUIRE(judged.kind == Kind::none);
      REQUIRE(judged.witness == true);
      REQUIRE(kind_of(truth, without_clips(collider.declaration, PointsAt::midpoint),
                      at_midpoints(truth.pair(), manifold)) == Kind::none);
    }
  });
}

TEST_CASE("a reversed normal is reversed, by a clip too") {
  for_overlapping([](const exact::Truth& truth, const Bounds&) {
    Penetration reversed = least_penetration(truth);
    reversed.normal = Vector2<double>(-reversed.normal.value());
    REQUIRE(kind_of(truth, separating(ScalarType::float32), reversed) == Kind::reversed);
    Manifold<double> manifold = clipped(truth.pair(), make_clip64());
    manifold.normal = -manifold.normal;
    const Declaration declaration = make_clip64().declaration;
    const Answer answer = manifold;
    REQUIRE(is_reversed(truth, {declaration, answer}));
  });
}

TEST_CASE("a depth that is off by ten bounds is inconsistent") {
  for_overlapping([](const exact::Truth& truth, const Bounds&) {
    const Declaration declaration = separating(ScalarType::float32);
    const double bound = curve_bounds(truth.pair(), declaration, truth.extent()).consistency;
    for (const double off : {-10.0, 10.0}) {
      Penetration wrong = least_penetration(truth);
      wrong.depth += off * bound;
      REQUIRE(kind_of(truth, declaration, wrong) == Kind::inconsistent);
    }
  });
}

TEST_CASE("a normal on a grid of 18 degrees is right only if it has the least depth") {
  int caught = 0;
  for_overlapping([&](const exact::Truth& truth, const Bounds&) {
    const Declaration declaration = separating(ScalarType::float32);
    Penetration coarse = least_penetration(truth);
    coarse.normal = on_grid(coarse.normal.value());
    const exact::Along along(truth, coarse.normal.value());
    coarse.depth = along.depth();
    const exact::PenetrationCurve curve(truth, exact::Skin::mitred);
    const double bound = curve_bounds(truth.pair(), declaration, truth.extent()).minimality;
    const bool is_least = curve.compare_excess(along, bound) <= 0;
    REQUIRE((kind_of(truth, declaration, coarse) == Kind::none) == is_least);
    caught += kind_of(truth, declaration, coarse) == Kind::not_minimal ? 1 : 0;
  });
  CHECK(caught > 500);
}

TEST_CASE("a normal that is 1% too long is wrong") {
  for_overlapping([](const exact::Truth& truth, const Bounds& bound) {
    if (bound.normal > 0.005) return;
    Penetration longer = least_penetration(truth);
    longer.normal.value() *= 1.01;
    REQUIRE(kind_of(truth, separating(ScalarType::float32), longer) == Kind::normal);
  });
}

TEST_CASE("a point that is off the surface by ten bounds is no witness") {
  for_overlapping([](const exact::Truth& truth, const Bounds&) {
    const Declaration declaration = without_clips(make_clip64().declaration);
    const CurveBounds bound = curve_bounds(truth.pair(), declaration, truth.extent());
    const Manifold<double> right = clipped(truth.pair(), make_clip64());
    for (const double off : {-10.0, 10.0}) {
      Manifold<double> moved = right;
      moved.points[0].position += off * bound.across * moved.normal;
      const CurveJudgement judged = judge_by_curve(truth, declaration, moved);
      // Where the surface is steep, or the overlap thin, another line has such a point.
      if (judged.kind == Kind::none) continue;
      REQUIRE(judged.kind == Kind::witness);
      REQUIRE(judged.witness == false);
    }
  });
}

TEST_CASE("no contact for an overlap is missed, one across a gap a phantom") {
  for_overlapping([](const exact::Truth& truth, const Bounds&) {
    const Declaration declaration = separating(ScalarType::float32);
    REQUIRE(kind_of(truth, declaration, Penetration{}) == Kind::missed_contact);
    PairCase apart = truth.pair();
    const Vector2<double> away =
        world_normal(apart, least_penetration(truth).normal.value()) * (2 * truth.extent());
    apart.b.pose.position += away.cast<float>();
    const exact::Truth far(apart);
    if (far.compare_contact(0) <= 0) return;
    Penetration distance = least_penetration(far);
    distance.depth = -distance.depth;  // a positive distance taken for a depth
    REQUIRE(kind_of(far, declaration, distance) == Kind::phantom_contact);
    REQUIRE(kind_of(far, declaration, Penetration{}) == Kind::none);
  });
}

TEST_CASE("one depth for all points is the deepest's") {
  int caught = 0;
  for_overlapping([&](const exact::Truth& truth, const Bounds&) {
    Declaration declaration = without_clips(make_clip64().declaration);
    declaration.shares_depth = true;
    Manifold<double> shared = clipped(truth.pair(), make_clip64());
    const auto [least, most] = std::minmax(shared.points[0].depth, shared.points[1].depth);
    if (shared.count < 2) return;
    for (auto& point : shared.points) point.depth = most;
    REQUIRE(kind_of(truth, declaration, shared) == Kind::none);
    declaration.shares_depth = false;
    caught += kind_of(truth, declaration, shared) == Kind::witness ? 1 : 0;
  });
  CHECK(caught > 300);
}
