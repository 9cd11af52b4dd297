#include <catch2/catch.hpp>

#include "external/campaigns.hpp"
#include "generating/regime.hpp"
#include "judging/by_curve.hpp"
#include "support/installed_collider.hpp"
#include "support/named_tests.hpp"

// Bullet and libccd, where they are installed: each answers as it should what it can tell.

using namespace manifuzz;
using namespace manifuzz::test;

namespace {

constexpr std::string_view kEngines[] = {"bullet-epa",       "bullet-minkowski", "bullet-convex2d",
                                         "bullet-perturbed", "libccd-gjk",       "libccd-mpr"};

Body square_at(float x, float y) {
  const std::array<Vector2<float>, 4> corners{Vector2<float>{-1, -1}, Vector2<float>{1, -1},
                                              Vector2<float>{1, 1}, Vector2<float>{-1, 1}};
  Body body;
  body.polygon = make_polygon<float>(corners);
  body.pose.position = {x, y};
  return body;
}

Body circle_at(float x, float y) {
  const std::array<Vector2<float>, 1> centre{Vector2<float>{0, 0}};
  Body body = square_at(x, y);
  body.polygon = make_polygon<float>(centre, 1);
  return body;
}

/// The answer's normal times its depth.
Vector2<double> translation_in(const Answer& answer) {
  const auto along = said_along(answer);
  return along ? Vector2<double>(along->depth * along->normal) : Vector2<double>(0, 0);
}

void check_translation(const Collider& engine, const PairCase& pair,
                       const Vector2<double>& wanted) {
  // Perturbed, the smaller shape is turned by 0.02 over its radius.
  const double off = engine.declaration.name == "bullet-perturbed" ? 2e-3 : 1e-4;
  const Answer answer = engine.collide(pair);
  REQUIRE(touches(answer));
  CHECK((translation_in(answer) - wanted).norm() < off);
}

void check_squares(const Collider& engine) {
  check_translation(engine, {square_at(0, 0), square_at(0.5F, 1.75F)}, {0, 0.25});
  check_translation(engine, {square_at(-3, 7), square_at(-3.5F, 5.25F)}, {0, -0.25});
  CHECK_FALSE(touches(engine.collide({square_at(0, 0), square_at(0.5F, 2.25F)})));
  CHECK_FALSE(touches(engine.collide({square_at(0, 0), square_at(-3, 2.25F)})));
}

void check_touch(const Collider& engine) {
  const Answer answer = engine.collide({square_at(0, 0), square_at(0.5F, 2)});
  if (touches(answer)) CHECK(translation_in(answer).norm() < 1e-4);
  check_translation(engine, {square_at(0, 0), square_at(0.5F, 2 - 0x1p-10F)}, {0, 0x1p-10});
}

void check_circles(const Collider& engine) {
  const PairCase two{circle_at(0, 0), circle_at(0, 1.75F)};
  if (!takes(engine, two)) {
    CHECK(std::holds_alternative<Unsupported>(engine.collide(two)));
    return;
  }
  check_translation(engine, two, {0, 0.25});
  check_translation(engine, {circle_at(0, 0), circle_at(1.125F, 1.5F)}, {0.075, 0.1});
  check_translation(engine, {square_at(0, 0), circle_at(0.5F, 1.75F)}, {0, 0.25});
  check_translation(engine, {circle_at(0.5F, -1.75F), square_at(0, 0)}, {0, 0.25});
  CHECK_FALSE(touches(engine.collide({circle_at(0, 0), circle_at(1.5F, 1.5F)})));
}

/// Nothing of what it can be given makes it die, or leave the plane often.
void check_campaign(const Collider& engine) {
  for (const Regime& regime : polygon_regimes()) {
    INFO(regime.name);
    Plan plan = plan_of(engine);
    plan.context.radius = 0.0F;
    plan.regimes = {&regime};
    plan.cases = 300;
    const JobsResult result = run(plan);
    CHECK(result.tally->cases() == 300);
    CHECK(result.tally->count(Verdict::crashed) == 0);
    CHECK(result.tally->count(Verdict::unsupported) <= 300 / 10);
  }
}

[[maybe_unused]] const bool registered = [] {
  const auto add = [](const std::string& name, std::string_view of,
                      void (*check)(const Collider& engine)) {
    add_test(std::string(of) + ": " + name, "[engines]", [of, check] {
      if (const auto engine = installed_collider(of)) check(*engine);
    });
  };
  for (const std::string_view engine : kEngines) {
    add("squares that overlap and that do not", engine, check_squares);
    add("squares that hardly touch", engine, check_touch);
    add("circles, or that it takes none", engine, check_circles);
    add("a campaign in every regime of polygons", engine, check_campaign);
  }
  return true;
}();

}  // namespace
