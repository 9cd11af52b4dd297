#include "exact/hausdorff.hpp"

#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "exact/curve.hpp"
#include "generating/regime.hpp"
#include "support/used_shapes_of.hpp"

namespace manifuzz {
namespace {

using test::used_vertices_of;

UsedVertices without(UsedVertices used, int vertex) {
  for (int i = vertex; i + 1 < used.count; ++i) used.all[i] = used.all[i + 1];
  --used.count;
  return used;
}

const std::array<Vector2<float>, 4> kCorners{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};

template <class Check>
void for_polygons(const Check& check) {
  for (const Regime& regime : polygon_regimes()) {
    for (std::uint64_t i = 0; i < 50; ++i) {
      INFO(regime.name << ", index " << i);
      check(generate(37, regime, i).a.polygon);
    }
  }
}

/// The distance from a point to the line through two others.
double distance_to_line(const Vector2<double>& p, const Vector2<double>& from,
                        const Vector2<double>& to) {
  const Vector2<double> edge = to - from;
  const Vector2<double> off = p - from;
  return std::abs(edge.x() * off.y() - edge.y() * off.x()) / edge.stableNorm();
}

}  // namespace

TEST_CASE("the same vertices, in any order, have distance 0") {
  for_polygons([](const ConvexPolygon<float>& polygon) {
    UsedVertices used = used_vertices_of(polygon);
    CHECK(exact::Alteration(polygon, used).distance() == 0);
    std::reverse(used.all.begin(), used.all.begin() + used.count);
    CHECK(exact::Alteration(polygon, used).distance() == 0);
    CHECK_FALSE(exact::Alteration(polygon, used).exceeds(0));
  });
}

TEST_CASE("a vertex that is dropped lies so far from what is left") {
  for_polygons([](const ConvexPolygon<float>& polygon) {
    if (polygon.count == 3) return;
    const UsedVertices used = used_vertices_of(polygon);
    const exact::Alteration dropped(polygon, without(used, 1));
    const double most = (used.all[1] - used.all[0]).stableNorm();
    CHECK(dropped.distance() >= 0.999 * distance_to_line(used.all[1], used.all[0], used.all[2]));
    CHECK(dropped.distance() <= 1.001 * most);
    CHECK(dropped.exceeds(0));
  });
}

TEST_CASE("a vertex that is moved outwards is that far away, and no farther than it was moved") {
  const auto polygon = make_polygon<float>(kCorners);
  UsedVertices used = used_vertices_of(polygon);
  used.all[2] = {1.5, 1.5};
  CHECK(exact::Alteration(polygon, used).distance() == std::sqrt(0.5));
  used.all[2] = {1, 1 + 0x1p-52};
  const exact::Alteration hardly(polygon, used);
  CHECK(hardly.distance() == 0x1p-52);
  CHECK(hardly.exceeds(std::nextafter(0x1p-52, 0)));
  CHECK_FALSE(hardly.exceeds(0x1p-52));
}

TEST_CASE("a polygon that shrank to an edge, or to a point, is as far as its farthest corner") {
  const auto polygon = make_polygon<float>(kCorners);
  UsedVertices used;
  used.all[0] = {-1, -1};
  used.all[1] = {1, -1};
  used.count = 2;
  CHECK(exact::Alteration(polygon, used).distance() == 2);
  used.count = 1;
  CHECK(exact::Alteration(polygon, used).distance() == std::sqrt(8));
}

TEST_CASE("a polygon that shrank and got round corners is off by what these cut") {
  const auto polygon = make_polygon<float>(kCorners);
  UsedVertices used = used_vertices_of(polygon);
  for (int i = 0; i < used.count; ++i) used.all[i] *= 0.75;
  used.round_radius = 0.25F;
  const exact::Alteration rounded(polygon, used);
  CHECK(rounded.distance() == Approx((std::sqrt(2) - 1) * 0.25));
  CHECK(rounded.exceeds(0.1035));
  CHECK_FALSE(rounded.exceeds(0.1036));
  used.round_radius = 0.75F;
  const exact::Alteration grown(polygon, used);
  CHECK(grown.distance() == Approx(0.5));
  CHECK(grown.exceeds(0.4999));
  CHECK_FALSE(grown.exceeds(0.5));
  used = used_vertices_of(polygon);
  used.round_radius = 0.5F;
  CHECK(exact::Alteration(polygon, used).distance() == Approx(0.5));
  used.round_radius = 0.0F;
  CHECK(exact::Alteration(polygon, used).distance() == 0);
}

TEST_CASE("used shapes with round corners have the truth of round shapes") {
  const auto polygon = make_polygon<float>(kCorners);
  const PairCase pair{{polygon, {}}, {polygon, {{2.25F, 2.25F}, {1, 0}}}};
  UsedShapes used{used_vertices_of(polygon), used_vertices_of(polygon)};
  for (const Side side : {Side::a, Side::b}) used[side].round_radius = 0.25F;
  const exact::Truth truth(pair, used);
  CHECK(is_round(truth.pair()));
  CHECK(exact::PenetrationCurve(truth, exact::skin_of(truth)).least() ==
        Approx(0.5 - std::sqrt(0.125)));
}

TEST_CASE("what is true of used shapes is decided to the last bit of double") {
  const auto polygon = make_polygon<float>(kCorners);
  const PairCase pair{{polygon, {}}, {polygon, {{2, 0.25F}, {1, 0}}}};
  CHECK(exact::Truth(pair).compare_contact(0) == 0);
  UsedShapes used{used_vertices_of(polygon), used_vertices_of(polygon)};
  CHECK(exact::Truth(pair, used).compare_contact(0) == 0);
  used.b.all[0].x() = used.b.all[3].x() = -1 + 0x1p-53;
  const exact::Truth apart(pair, used);
  CHECK(apart.compare_contact(0) > 0);
  CHECK(exact::PenetrationCurve(apart, exact::Skin::mitred).least() == -0x1p-53);
  used.b.all[0].x() = used.b.all[3].x() = -1 - 0x1p-52;
  CHECK(exact::Truth(pair, used).compare_contact(0) < 0);
}

TEST_CASE("used shapes that are another pair's have that pair's truth") {
  for (const Regime& regime : polygon_regimes()) {
    for (std::uint64_t i = 0; i < 50; ++i) {
      PairCase pair = generate(41, regime, i);
      const PairCase other = generate(43, regime, i);
      const UsedShapes used{used_vertices_of(other.a.polygon), used_vertices_of(other.b.polygon)};
      pair.a.polygon.radius = other.a.polygon.radius;
      pair.b.polygon.radius = other.b.polygon.radius;
      const exact::Truth of_used(pair, used);
      PairCase expected{{other.a.polygon, pair.a.pose}, {other.b.polygon, pair.b.pose}};
      const exact::Truth truth(expected);
      CHECK(of_used.pair() == expected);
      CHECK(of_used.greatest() == truth.greatest());
      CHECK(of_used.compare_contact(0) == truth.compare_contact(0));
      CHECK(exact::PenetrationCurve(of_used, exact::Skin::round).least() ==
            exact::PenetrationCurve(truth, exact::Skin::round).least());
    }
  }
}

}  // namespace manifuzz
