#include "clipping/collide.hpp"

#include <catch2/catch.hpp>

#include "own_colliders/own_colliders.hpp"
#include "unit/clipping/squares.hpp"

using namespace manifuzz;
using namespace manifuzz::test;
using Catch::Matchers::WithinAbs;

namespace {

Manifold<float> collide_at(const ConvexPolygon<float>& a, const ConvexPolygon<float>& b, float x,
                           float y, float bias = 0) {
  return clipping::collide<float>(a, b, {{x, y}, {1, 0}}, bias);
}

}  // namespace

TEST_CASE("apart beyond the total radius: no contact") {
  CHECK(collide_at(square(), square(), 2.5F, 0).count == 0);
  CHECK(collide_at(square(0.125F), square(0.125F), 2.5F, 0).count == 0);
}

TEST_CASE("rounded polygons touch up to the total radius, at depth zero") {
  const auto m = collide_at(square(0.25F), square(0.25F), 2.5F, 0);
  REQUIRE(m.count == 2);
  CHECK(m.normal == Vector2<float>(1, 0));
  CHECK(m.points[0].depth == 0);
}

TEST_CASE("side planes are widened by the total radius") {
  const auto m = collide_at(square(0.25F), square(), 1.75F, 1.0F);
  REQUIRE(m.count == 2);
  CHECK(m.points[0].position.y() == 0);
  CHECK(m.points[1].position.y() == 1.25F);
}

TEST_CASE("a tie goes to A, and a bias keeps A's face while B's lead is within it") {
  CHECK(collide_at(square(), square(), 1.5F, 0).reference == Side::a);
  const auto wedge = polygon({{0, 0}, {0.5F, -2}, {0.5F, 2}});
  const auto rod = polygon({{-2, -0.05F}, {0.25F, -0.05F}, {0.25F, 0.05F}, {-2, 0.05F}});
  CHECK(collide_at(wedge, rod, 0, 0).reference == Side::b);  // S_A -0.2547, S_B -0.25
  CHECK(collide_at(wedge, rod, 0, 0, 0.004F).reference == Side::b);
  CHECK(collide_at(wedge, rod, 0, 0, 0.005F).reference == Side::a);
}

TEST_CASE("an overlap whose chosen face misses the deepest vertex still has a contact") {
  // A's tiny face of equal separation would clip the edge away: Box2D 2.4.1 reports nothing here.
  const Collider clip = make_clip(0.0005);
  PairCase pair;
  pair.a.polygon = polygon({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
  pair.b.polygon = polygon({{0, 0}, {1, 1}, {-1, 1}});
  pair.b.pose.position = {0, 0.9F};
  const auto manifold = std::get<Manifold<double>>(clip.collide(pair));
  REQUIRE(manifold.count >= 1);
  CHECK_THAT(manifold.points[0].depth, WithinAbs(0.1, 1e-6));
}

TEST_CASE("clip64 divides where a rotation is not quite unit, and scales depths") {
  const Collider clip64 = make_clip64();
  PairCase pair;
  pair.a.polygon = square();
  pair.b.polygon = square();
  pair.a.pose.rotation = {1.000004F, 0};
  pair.b.pose.position = {1.5F, 0};
  const double k = static_cast<double>(1.000004F);
  const auto m = std::get<Manifold<double>>(clip64.collide(pair));
  REQUIRE(m.count == 2);
  CHECK_THAT(m.points[0].depth, WithinAbs(k * 1 + 1 - 1.5, 1e-15));
  CHECK_THAT(m.points[0].position.x(), WithinAbs(0.5 / k, 1e-15));
}

TEST_CASE("a given normal may be approximate: the manifold has the face's exact one") {
  const Vector2<float> rough{0.05F, -0.99F};
  const auto m =
      clipping::manifold_from_normal<float>(square(), square(), {{0.5F, -1.75F}, {1, 0}}, rough);
  REQUIRE(m.count == 2);
  CHECK(m.normal == Vector2<float>(0, -1));
  CHECK(m.points[0].depth == 0.25F);
  CHECK(m.points[1].depth == 0.25F);
}
