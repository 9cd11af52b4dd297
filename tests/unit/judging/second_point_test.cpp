#include "judging/second_point.hpp"

#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

#include "own_colliders/own_colliders.hpp"

using namespace manifuzz;

namespace {

using Vertices = std::vector<Vector2<float>>;

ConvexPolygon<float> capsule(const Vertices& ends) {
  ConvexPolygon<float> shape = make_polygon<float>(ends, 0.5F);
  shape.rounding = Rounding::round;
  return shape;
}

ConvexPolygon<float> box() {
  return make_polygon<float>(Vertices{{-1.5F, -1}, {1.5F, -1}, {1.5F, 1}, {-1.5F, 1}}, 0.0F);
}

/// A capsule that stands on a box: its axis is turned by so much from the normal.
PairCase standing_on_box(double turn) {
  const Vector2<float> rotation{static_cast<float>(std::cos(turn)),
                                static_cast<float>(std::sin(turn))};
  return {{box(), {}}, {capsule({{0, 0}, {0, 2}}), {{0.3F, 1.4F}, rotation}}};
}

/// A manifold whose normal points up, the deepest point first.
Manifold<double> upwards(const std::vector<ContactPoint<double>>& points) {
  Manifold<double> manifold;
  manifold.normal = {0, 1};
  for (const ContactPoint<double>& point : points) manifold.points[manifold.count++] = point;
  return manifold;
}

Kind kind_of(const PairCase& pair, const Manifold<double>& manifold) {
  return judge_by_curve(exact::Truth(pair), make_clip().declaration, manifold).kind;
}

}  // namespace

TEST_CASE("a capsule that stands on the middle of a face has one point") {
  const ContactPoint<double> end{.position = {0.3F, 0.9F}, .depth = 0.1, .features = {}};
  const ContactPoint<double> above{.position = {0.3F, 0.95F}, .depth = 0.05, .features = {}};
  for (const double turn : {1e-4, 1e-5, 3e-6, 1e-6, 1e-7, -1e-6}) {
    CAPTURE(turn);
    const PairCase pair = standing_on_box(turn);
    CHECK(kind_of(pair, upwards({end})) == Kind::none);
    CHECK(kind_of(pair, upwards({end, above})) == Kind::count);
  }
}

TEST_CASE("a capsule that lies on a thin triangle has two points, however thin") {
  const Vector2<float> place{0, 0.4F};
  for (const float thickness : {0.5F, 1e-3F, 1e-6F, 3e-7F}) {
    CAPTURE(thickness);
    const PairCase pair{{make_polygon<float>(Vertices{{-1, 0}, {0, -thickness}, {1, 0}}, 0.0F), {}},
                        {capsule({{-0.8F, 0}, {0.8F, 0}}), {place, {1, 0}}}};
    const ContactPoint<double> right{.position = {0.8F, -0.1}, .depth = 0.1, .features = {}};
    const ContactPoint<double> left{.position = {-0.8F, -0.1}, .depth = 0.1, .features = {}};
    CHECK(kind_of(pair, upwards({right, left})) == Kind::none);
    CHECK(kind_of(pair, upwards({right})) == Kind::count);
  }
}
