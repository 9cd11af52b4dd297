#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

#include "afresh/afresh.hpp"
#include "scene/scene.hpp"
#include "unit/scene/squares.hpp"

using namespace manifuzz;
using scene::Afresh;
using scene::Defect;
using scene::Scene;
using test::kInfinity;
using test::square;

TEST_CASE("shapes that leave rounding no room are refused") {
  Scene scene;
  CHECK(std::get<Defect>(scene.add_shape(square(1e16F))) == Defect::shape_too_large);
  CHECK(std::get<Defect>(scene.add_shape(square(1, kInfinity))) == Defect::shape_too_large);
  const std::array<Vector2<float>, 3> needle{{{0, 0}, {1, 0}, {1, 1e-5F}}};
  CHECK(std::get<Defect>(scene.add_shape(make_polygon<float>(needle))) == Defect::shape_too_sharp);
  CHECK(std::get<std::uint32_t>(scene.add_shape(square(1))) == 0);
  const auto round_needle = make_polygon<float>(needle, 0.0F, Rounding::round);
  CHECK(std::get<std::uint32_t>(scene.add_shape(round_needle)) == 1);
}

TEST_CASE("shapes that are no polygons are refused, and what was there stays") {
  Scene scene;
  REQUIRE(std::get<std::uint32_t>(scene.add_shape(square(1))) == 0);
  const auto refused = [&](const std::vector<Vector2<float>>& vertices) {
    const Defect defect = std::get<Defect>(scene.add_shape(make_polygon<float>(vertices)));
    CHECK(std::get<Defect>(Afresh().add_shape(make_polygon<float>(vertices))) == defect);
    return defect;
  };
  CHECK(refused({{0, 0}, {4, 0}, {1, 1}, {0, 4}}) == Defect::shape_not_convex);
  CHECK(refused({{0, 0}, {0, 1}, {1, 0}}) == Defect::shape_not_convex);
  CHECK(refused({{0, 0}, {0, 0}, {1, 0}}) == Defect::shape_not_convex);
  CHECK(refused({{0, 0}, {0, 0}}) == Defect::shape_not_convex);
  CHECK(refused({{0, 0}}) == Defect::shape_not_convex);
  CHECK(refused({{0, 0}, {1, 0}, {1, std::nanf("")}}) == Defect::shape_not_convex);
  ConvexPolygon<float> nine = square(1);
  nine.count = 9;
  CHECK(std::get<Defect>(scene.add_shape(nine)) == Defect::shape_not_convex);
  ConvexPolygon<float> hollow = square(1);
  hollow.radius = -1;
  CHECK(std::get<Defect>(scene.add_shape(hollow)) == Defect::shape_too_large);
  CHECK(std::get<std::uint32_t>(scene.add_shape(square(1))) == 1);
}
