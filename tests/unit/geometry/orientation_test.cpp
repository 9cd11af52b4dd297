#include "geometry/orientation.hpp"

#include <catch2/catch.hpp>

using namespace manifuzz;

TEST_CASE("orientation tells left from right from straight") {
  const Vector2<float> a(0, 0);
  const Vector2<float> b(1, 0);
  CHECK(orientation(a, b, Vector2<float>(0, 1)) == 1);
  CHECK(orientation(a, b, Vector2<float>(0, -1)) == -1);
  CHECK(orientation(a, b, Vector2<float>(7, 0)) == 0);
}
