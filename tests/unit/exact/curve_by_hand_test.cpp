#include <array>
#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

#include "exact/curve.hpp"

namespace manifuzz {
namespace {

using exact::Along;
using exact::PenetrationCurve;
using exact::Skin;
using exact::Truth;

ConvexPolygon<float> square(float radius) {
  const std::array<Vector2<float>, 4> corners{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  return make_polygon<float>(corners, radius);
}

}  // namespace

TEST_CASE("the depth along a normal of two unit boxes, by hand") {
  const auto polygon = square(0);
  const PairCase pair{{polygon, {}}, {polygon, {{1.5F, 0.5F}, {1, 0}}}};
  const Truth truth(pair);
  const PenetrationCurve curve(truth, Skin::round);
  CHECK(curve.least() == 0.5);
  CHECK(curve.minima(0) == std::vector{Vector2<double>(1, 0)});
  CHECK(curve.minima(1).size() == 2);  // and (0, 1), of depth 1.5
  const Along up(truth, {0, 1});
  CHECK(up.depth() == 1.5);
  CHECK(up.gap() == 1.5);
  const Along diagonal(truth, {1, 1});
  CHECK(diagonal.depth() == Approx(std::sqrt(2.0)));
  CHECK(diagonal.gap() == Approx(std::sqrt(0.5)));
  CHECK(Along(truth, {-1, 0}).depth() == 3.5);
}

TEST_CASE("corners that are apart by less than pairs of doubles tell have a normal") {
  const auto polygon = square(0);
  const PairCase pair{{polygon, {}}, {polygon, {{2, 2}, {1, 0}}}};
  PairCase apart = pair;
  apart.a.pose.position.y() = -3e-45F;
  const Truth truth(apart);
  const PenetrationCurve curve(truth, Skin::round);
  CHECK(curve.compare_least(0) < 0);
  CHECK(curve.minima(0) == std::vector{Vector2<double>(0, 1)});
}

TEST_CASE("round cores that are apart are nearest between two corners, or at a face") {
  const auto polygon = square(2);
  const auto least_at = [&](float x, float y, Skin skin) {
    const Truth truth(PairCase{{polygon, {}}, {polygon, {{x, y}, {1, 0}}}});
    return PenetrationCurve(truth, skin).least();
  };
  CHECK(least_at(5, 6, Skin::round) == 4 - 5);
  CHECK(least_at(5, 6, Skin::mitred) == 4 - 4);
  CHECK(least_at(5, 1, Skin::round) == 4 - 3);
  CHECK(least_at(5, 2, Skin::round) == 4 - 3);  // corner to corner, along a face's normal
}

}  // namespace manifuzz
