#include "report/picture/region.hpp"

#include <catch2/catch.hpp>

#include "unit/report/sample.hpp"

using namespace manifuzz;
using namespace manifuzz::test;

namespace {

Region square(double x, double y, double side) {
  return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

double area(const Region& region) {
  double twice = 0;
  for (std::size_t i = 0; i < region.size(); ++i) {
    twice += cross<double>(region[i], region[(i + 1) % region.size()]);
  }
  return twice / 2;
}

constexpr Box kEverything{-100, -100, 200, 200};

}  // namespace

TEST_CASE("two squares share the square between their corners") {
  CHECK(area(intersection(square(0, 0, 2), square(1.5, 1, 3))) == Approx(0.5));
}

TEST_CASE("a region inside another is what they share") {
  CHECK(area(intersection(square(0, 0, 4), square(1, 1, 1))) == Approx(1));
  CHECK(area(intersection(square(1, 1, 1), square(0, 0, 4))) == Approx(1));
}

TEST_CASE("regions apart share nothing") {
  CHECK(intersection(square(0, 0, 1), square(2, 0, 1)).empty());
}

TEST_CASE("a region is cut to a box, whichever way it turns") {
  Region region = square(-1, -1, 2);
  CHECK(area(intersection(region, Box{0, 0, 5, 5})) == Approx(1));
  std::reverse(region.begin(), region.end());
  CHECK(area(intersection(region, Box{0, 0, 5, 5})) == Approx(-1));
}

TEST_CASE("a segment is cut to a box") {
  const Box box{0, 0, 2, 1};
  const auto through = inside({{-1, 0.5}, {3, 0.5}}, box);
  REQUIRE(through);
  CHECK(through->first == Point(0, 0.5));
  CHECK(through->second == Point(2, 0.5));
  CHECK_FALSE(inside({{-1, 2}, {3, 2}}, box));
  CHECK_FALSE(inside({{-1, 0.5}, {-0.5, 0.5}}, box));
  CHECK_FALSE(inside({{-1, 0}, {1, 4}}, box));
  CHECK(inside({{1, 0.5}, {1, 0.5}}, box));
  CHECK_FALSE(inside({{1, 5}, {1, 5}}, box));
}

TEST_CASE("how deep a point lies in a region") {
  CHECK(depth_in(square(0, 0, 4), {1, 2}) == Approx(1));
  CHECK(depth_in(square(0, 0, 4), {6, 2}) == Approx(-2));
}

TEST_CASE("a rounded square has the area of its skin") {
  const exact::RoughPair world = exact::place_roughly(box_on_box(0));
  const double pi = 3.14159265358979;
  const Region skin = rounded(world.a, 0.5, kEverything, 1e-6);
  CHECK(area(skin) == Approx(4 + 4 * 2 * 0.5 + pi * 0.25).epsilon(1e-5));
  CHECK(area(rounded(world.a, 0, kEverything, 1e-6)) == Approx(4));
}

TEST_CASE("arcs are fine where they are looked at, and coarse elsewhere") {
  const exact::RoughPair world = exact::place_roughly(box_on_box(0));
  const double sine = 0.70710678118654752;
  const Point top = Point(1, 1) + 0.5 * Point(sine, sine);
  const Box about = Box{top.x(), top.y(), 0, 0}.grown(1e-6);
  const Region skin = rounded(world.a, 0.5, about, 1e-12);
  CHECK(std::abs(depth_in(skin, top)) < 1e-11);
  CHECK(skin.size() < 400);
}
