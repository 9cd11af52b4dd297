#include "methods/cached_points.hpp"

#include <catch2/catch.hpp>

#include "unit/methods/kept.hpp"

using namespace manifuzz;
using namespace manifuzz::methods;
using test::below_top;
using test::ids;
using test::Kept;

namespace {

const Pose<double> kHere{};

Pose<double> at(double x, double y) {
  return {{x, y}, {1, 0}};
}

using Ids = std::vector<int>;

}  // namespace

TEST_CASE("a point stays where it is while another one is detected, its depth measured anew") {
  Kept kept;
  kept.frame(kHere, below_top(-1, 0.5));
  kept.frame(at(0, 0.125), below_top(1, 0.375));
  REQUIRE(ids(kept) == Ids{0, 1});
  CHECK(kept.cache.points[0].born == 0);
  CHECK(kept.cache.points[1].born == 1);
  CHECK(kept.cache.points[0].depth == 0.375);
  CHECK(kept.cache.points[0].anchor_b == Vector2<double>(-1, -0.5));
}

TEST_CASE("a point is kept across a gap up to the limit, and no farther") {
  Kept kept;
  kept.frame(kHere, below_top(0, 0));
  kept.frame(at(0, 0.25), {});
  CHECK(ids(kept) == Ids{0});
  CHECK(kept.cache.points[0].depth == -0.25);
  kept.frame(at(0, 0.2500001), {});
  CHECK(ids(kept).empty());
}

TEST_CASE("a point is kept while its anchors slide on each other up to the limit, since birth") {
  Kept kept;
  kept.frame(kHere, below_top(0, 1));
  kept.frame(at(0.125, 0), {});
  kept.frame(at(-0.25, 0), {});
  CHECK(ids(kept) == Ids{0});
  kept.frame(at(-0.2500001, 0), {});
  CHECK(ids(kept).empty());
}

TEST_CASE("a point is kept while B turns on it up to the limit, since birth") {
  Kept kept;
  kept.frame(kHere, below_top(0, 0));
  kept.frame(test::turned(std::sin(0.2)), {});
  kept.frame(test::turned(std::sin(-0.2499)), {});
  CHECK(ids(kept) == Ids{0});
  kept.frame(test::turned(std::sin(0.2501)), {});
  CHECK(ids(kept).empty());
}

TEST_CASE("a new point takes the place and the id of one that is near on either body") {
  Kept kept;
  kept.frame(kHere, below_top(0, 0.5));
  kept.frame(kHere, below_top(1, 0.5));
  // B's corner at (0, -0.5) has slid to 0.2 on A, and A's place at 1.2 is new on B.
  kept.frame(at(0.2, 0), below_top(0.2, 0.5));
  CHECK(ids(kept) == Ids{0, 1});
  CHECK(kept.cache.points[0].born == 2);
  CHECK(kept.cache.points[0].anchor_a == Vector2<double>(0.2, 0));
  kept.frame(at(0.2, 0), below_top(0.9, 0.5));
  CHECK(ids(kept) == Ids{0, 1});
  CHECK(kept.cache.points[1].born == 3);
}

TEST_CASE("of two points in reach the nearer one is replaced") {
  Kept kept;
  kept.limits.match = 0.5;
  kept.frame(kHere, below_top(0, 0.5));
  kept.frame(kHere, below_top(0.75, 0.5));
  kept.frame(kHere, below_top(0.45, 0.5));
  CHECK(kept.cache.points[0].anchor_a.x() == 0);
  CHECK(kept.cache.points[1].anchor_a.x() == 0.45);
  CHECK(ids(kept) == Ids{0, 1});
}

TEST_CASE("the deepest point stays, and the farthest to either side, the others go") {
  Kept kept;
  for (const auto& [x, depth] : {std::pair(0.0, 0.5), {-1.0, 0.25}, {1.0, 0.125}}) {
    kept.frame(kHere, below_top(x, depth));
  }
  CHECK(ids(kept) == Ids{0, 1, 2});
  kept.frame(kHere, below_top(0.5, 0.375));
  CHECK(ids(kept) == Ids{0, 1, 2});
  kept.frame(kHere, below_top(0.5, 0.625));
  CHECK(ids(kept) == Ids{1, 2, 4});
  kept.frame(kHere, below_top(2, 0.125));
  CHECK(ids(kept) == Ids{1, 4, 5});
}

TEST_CASE("ends are told in A's frame, however B is turned in it") {
  Kept kept;
  const Pose<double> quarter{{3, 4}, {0, 1}};
  for (const double x : {-1.0, 1.0, 0.0}) kept.frame(quarter, below_top(x, 0.5 + x / 8));
  CHECK(ids(kept) == Ids{0, 1});
}

TEST_CASE("of equal depths the last born is the deepest") {
  Kept kept;
  for (const double x : {-1.0, 1.0, 0.25, -0.25}) kept.frame(kHere, below_top(x, 0.5));
  CHECK(ids(kept) == Ids{0, 1, 3});
}

TEST_CASE("a normal turns with the body whose face it is of, and with no other") {
  for (const Side carrier : {Side::a, Side::b}) {
    Kept kept;
    kept.frame(kHere, below_top(0, 0.5, carrier));
    const Pose<double> turned = test::turned(0.125);
    kept.frame(turned, {});
    REQUIRE(ids(kept) == Ids{0});
    const Vector2<double> now = normal_in_a(kept.cache.points[0], turned);
    const Vector2<double> expected =
        carrier == Side::a ? Vector2<double>(0, 1) : rotate<double>(turned.rotation, {0, 1});
    CHECK(now.x() == Approx(expected.x()).margin(1e-15));
    CHECK(now.y() == Approx(expected.y()));
    const Vector2<double> on_b = rotate<double>(turned.rotation, {0, -0.5});
    CHECK(kept.cache.points[0].depth == Approx(-expected.dot(on_b)));
  }
}

TEST_CASE(
    "a normal of B is unit and B's whatever B's turn is at birth, and its rotation's length") {
  const Pose<double> turned{{0.5, 0.25}, {0.600003, 0.800004}};
  Kept kept;
  kept.frame(turned, below_top(0, 0.5, Side::b));
  const CachedPoint<double>& point = kept.cache.points[0];
  CHECK(point.normal.norm() == Approx(1).epsilon(1e-15));
  const Vector2<double> now = normal_in_a(point, turned);
  CHECK(now.x() == Approx(0).margin(1e-15));
  CHECK(now.y() == Approx(1).epsilon(1e-15));
  CHECK(point.depth == Approx(0.5).epsilon(1e-15));
}

TEST_CASE("anchors are on both surfaces, a depth apart along the normal") {
  const auto box = [](double y, double radius, Rounding rounding) {
    const std::vector<Vector2<double>> vertices = {
        {-1, y - 1}, {1, y - 1}, {1, y + 1}, {-1, y + 1}};
    return make_polygon<double>(vertices, radius, rounding);
  };
  for (const Rounding rounding : {Rounding::mitre, Rounding::round}) {
    const auto a = box(0, 0.25, rounding);
    const auto b = box(2.5, 0.5, rounding);
    for (const Side reference : {Side::a, Side::b}) {
      Manifold<double> manifold{1, reference, {0, 1}, {}};
      // A's core ends at 1 and its surface at 1.25; B's at 1.5 and 1.
      const bool is_round = rounding == Rounding::round;
      const double on_b = is_round ? 1 : 1.5;
      const double on_a = is_round ? 1.25 : 1;
      manifold.points[0] = {{0.5, reference == Side::a ? on_b : on_a}, 0.25, {}};
      const DetectedPoint<double> found = detected_point(a, b, manifold);
      CHECK(found.on_a == Vector2<double>(0.5, 1.25));
      CHECK(found.on_b == Vector2<double>(0.5, 1));
      CHECK(found.carrier == reference);
    }
  }
}
