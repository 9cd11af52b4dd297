#include "judging/bound_shares.hpp"

#include <cmath>

#include <catch2/catch.hpp>

#include "generating/regime.hpp"
#include "judging/by_curve.hpp"
#include "judging/judge.hpp"
#include "own_colliders/own_colliders.hpp"

using namespace manifuzz;

namespace {

/// Two circles of radius 1, the second 1.5 above the first, which is right of the origin.
PairCase circles() {
  const Vector2<float> centre[] = {{0, 0}};
  const auto circle = make_polygon<float>(centre, 1);
  return {{circle, {{3, 0}, {1, 0}}}, {circle, {{3, 1.5F}, {1, 0}}}};
}

/// What `clip64` says of circles, its depth and normal changed.
Manifold<double> answered(double more_depth, double turned) {
  auto manifold = std::get<Manifold<double>>(make_clip64().collide(circles()));
  manifold.points[0].depth += more_depth;
  manifold.normal = {std::sin(turned), std::cos(turned)};
  return manifold;
}

ManifoldError shares_of(const PairCase& pair, const Declaration& declaration,
                        const Answer& answer) {
  return curve_shares(exact::Truth(pair), {declaration, answer});
}

}  // namespace

TEST_CASE("a depth of circles takes a share of the bound of a separation, whatever the normal's") {
  const Declaration declaration = make_clip().declaration;
  const double bound = bounds(circles(), declaration).separation;
  for (const double share : {0.0, 0.25, 0.5, 1 - 0x1p-20}) {
    CHECK(shares_of(circles(), declaration, answered(share * bound, 0)).depth ==
          Approx(share).margin(1e-6));
    CHECK(shares_of(circles(), declaration, answered(-share * bound, 0)).depth ==
          Approx(share).margin(1e-6));
  }
}

TEST_CASE("a normal of circles takes a share of what a turn is allowed") {
  const Declaration declaration = make_clip().declaration;
  const Bounds within = bounds(circles(), declaration);
  const double bound = within.normal + within.separation / (1.5 - within.separation);
  for (const double share : {0.25, 0.5, 1 - 0x1p-20}) {
    const Manifold<double> answer = answered(0, share * bound);
    CHECK(shares_of(circles(), declaration, answer).normal == Approx(share).margin(1e-6));
    const Judgement judgement =
        judge_alone(std::make_shared<const exact::Truth>(circles()), {declaration, Answer(answer)});
    CHECK(judgement.bucket.fault == Fault::none);
  }
}

TEST_CASE("of what says that they are apart, or is held to no bounds, nothing takes a share") {
  Declaration declaration = make_clip().declaration;
  CHECK(shares_of(circles(), declaration, Manifold<double>{}).depth == 0);
  declaration.tolerance.absolute = 0.01;
  CHECK(shares_of(circles(), declaration, answered(1e-7, 1e-7)).depth == 0);
}

TEST_CASE("no share of a right answer exceeds 1, of any collider of one point and any regime") {
  for (const Collider& collider : {make_gjk(), make_gjk64(), make_perturbed(), make_clip()}) {
    CAPTURE(collider.declaration.name);
    int measured = 0;
    for (const Regime& regime : regimes()) {
      for (std::uint64_t index = 0; index < 60; ++index) {
        const PairCase pair = generate(11, regime, index);
        if (!is_judged_by_curve(collider.declaration, pair)) continue;
        const Answer answer = collider.collide(pair);
        const auto truth = std::make_shared<const exact::Truth>(pair);
        const ColliderAnswer given{collider.declaration, answer};
        if (judge_alone(truth, given).bucket.fault != Fault::none) continue;
        const ManifoldError shares = curve_shares(*truth, given);
        CHECK(shares.normal <= 1);
        CHECK(shares.depth <= 1);
        measured += shares.normal > 0 && shares.depth > 0;
      }
    }
    CHECK(measured > 100);
  }
}
