#include "geometry/pair_case.hpp"

#include <algorithm>
#include <vector>

#include <catch2/catch.hpp>

using namespace manifuzz;

namespace {

using Outline = std::vector<Vector2<float>>;

/// A triangle of sides 3, 4 and 5 with reach 5, and a box of diameter 2 sqrt 2 and reach sqrt 2.
PairCase triangle_and_box() {
  PairCase pair;
  pair.a.polygon = make_polygon<float>(Outline{{0, 0}, {3, 0}, {3, 4}}, 0.25F);
  pair.b.polygon = make_polygon<float>(Outline{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, 0.5F);
  pair.a.pose.position = {1e6F, 0};
  pair.b.pose.position = {1e6F + 6, 8};
  return pair;
}

}  // namespace

TEST_CASE("a pair's sides") {
  PairCase pair = triangle_and_box();
  CHECK(pair[Side::a] == pair.a);
  CHECK(pair[Side::b] == pair.b);
  CHECK(other(Side::a) == Side::b);
  CHECK(other(Side::b) == Side::a);
  pair[Side::b].pose.position = {0, 0};
  CHECK(pair.b.pose.position == Vector2<float>(0, 0));
}

TEST_CASE("pairs differ by polygons and poses") {
  const PairCase pair = triangle_and_box();
  CHECK(pair == triangle_and_box());
  PairCase moved = pair;
  moved.b.pose.position.y() = 9;
  CHECK_FALSE(moved == pair);
  PairCase rounder = pair;
  rounder.a.polygon.radius = 0.5F;
  CHECK_FALSE(rounder == pair);
}

TEST_CASE("the total radius is both polygons'") {
  CHECK(total_radius(triangle_and_box()) == 0.75);
}

TEST_CASE("the size is the smaller polygon's diameter") {
  CHECK(size(triangle_and_box()) == Approx(2 * std::sqrt(2.0)));
}

TEST_CASE("the size is that of the smaller polygon, on either side and however long it lies") {
  const std::vector<Outline> outlines{
      {{0, 0}, {3, 0}, {3, 4}},           {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}},
      {{0, -1}, {9, 0}, {0, 1}, {-9, 0}}, {{-2, 0}, {0, -0.125F}, {2, 0}, {0, 0.125F}},
      {{0, 0}, {1e-3F, 0}, {0, 1e-3F}},   {{12, 0}, {4, 12}, {-6, 11}, {-11, -3}, {1, -12}},
  };
  for (const Outline& a : outlines) {
    for (const Outline& b : outlines) {
      PairCase pair;
      pair.a.polygon = make_polygon<float>(a);
      pair.b.polygon = make_polygon<float>(b);
      CHECK(size(pair) == std::min(diameter(pair.a.polygon), diameter(pair.b.polygon)));
    }
  }
}

TEST_CASE("the extent is both reaches and the distance between the origins") {
  CHECK(extent(triangle_and_box()) == Approx(5 + std::sqrt(2.0) + 10));
}
