#include <catch2/catch.hpp>

#include "clipping/collide.hpp"

// The three worked examples of "Contact Points Using Clipping". The article prints the edges only;
// the boxes are completed so that its normal and depth come out.

using namespace manifuzz;
using Catch::Matchers::WithinAbs;

namespace {

template <class Scalar>
ConvexPolygon<Scalar> polygon(std::vector<Vector2<Scalar>> vertices) {
  return make_polygon<Scalar>(vertices);
}

/// World coordinates are local ones: both poses are the identity.
template <class Scalar>
struct Example {
  ConvexPolygon<Scalar> a;
  ConvexPolygon<Scalar> b;
  Vector2<Scalar> normal;
};

template <class Scalar>
Example<Scalar> example1() {
  return {polygon<Scalar>({{8, 4}, {14, 4}, {14, 9}, {8, 9}}),
          polygon<Scalar>({{4, 2}, {12, 2}, {12, 5}, {4, 5}}),
          {0, -1}};
}

template <class Scalar>
Example<Scalar> example2() {
  return {polygon<Scalar>({{2, 8}, {6, 4}, {9, 7}, {5, 11}}),
          polygon<Scalar>({{4, 2}, {12, 2}, {12, 5}, {4, 5}}),
          {0, -1}};
}

template <class Scalar>
Example<Scalar> example3() {
  return {polygon<Scalar>({{9, 4}, {13, 3}, {14, 7}, {10, 8}}),
          polygon<Scalar>({{4, 2}, {12, 2}, {12, 5}, {4, 5}}),
          {Scalar(-0.19), Scalar(-0.98)}};
}

template <class Scalar>
void expect_point(const ContactPoint<Scalar>& point, double x, double y, double depth,
                  FeaturePair features, double within) {
  CHECK_THAT(static_cast<double>(point.position.x()), WithinAbs(x, within));
  CHECK_THAT(static_cast<double>(point.position.y()), WithinAbs(y, within));
  CHECK_THAT(static_cast<double>(point.depth), WithinAbs(depth, within));
  CHECK(point.features == features);
}

constexpr Feature vertex(unsigned char i) {
  return {Feature::Kind::vertex, i};
}
constexpr Feature face(unsigned char i) {
  return {Feature::Kind::face, i};
}

/// Both entries of the library on one example.
template <class Scalar, class Check>
void check_both_entries(const Example<Scalar>& example, Check check) {
  SECTION("from the given normal") {
    check(clipping::manifold_from_normal<Scalar>(example.a, example.b, Pose<Scalar>{},
                                                 example.normal));
  }
  SECTION("from collide") {
    check(clipping::collide<Scalar>(example.a, example.b, Pose<Scalar>{}));
  }
}

}  // namespace

TEMPLATE_TEST_CASE("example 1: two points, both at depth 1, exactly", "", float, double) {
  check_both_entries(example1<TestType>(), [](const Manifold<TestType>& m) {
    REQUIRE(m.count == 2);
    CHECK(m.reference == Side::a);
    CHECK(m.normal == Vector2<TestType>(0, -1));
    expect_point(m.points[0], 8, 5, 1, {vertex(0), face(2)}, 0);
    expect_point(m.points[1], 12, 5, 1, {face(0), vertex(2)}, 0);
  });
}

TEMPLATE_TEST_CASE("example 2: the clipped end lies in front and goes", "", float, double) {
  check_both_entries(example2<TestType>(), [](const Manifold<TestType>& m) {
    REQUIRE(m.count == 1);
    CHECK(m.reference == Side::b);
    CHECK(m.normal == Vector2<TestType>(0, -1));
    expect_point(m.points[0], 6, 4, 1, {vertex(1), face(2)}, 0);
  });
}

TEMPLATE_TEST_CASE("example 3: each point has its own depth", "", float, double) {
  const double within = 8 * static_cast<double>(std::numeric_limits<TestType>::epsilon());
  const double root17 = std::sqrt(17.0);
  check_both_entries(example3<TestType>(), [&](const Manifold<TestType>& m) {
    REQUIRE(m.count == 2);
    CHECK(m.reference == Side::a);
    CHECK_THAT(static_cast<double>(m.normal.x()), WithinAbs(-1 / root17, within));
    CHECK_THAT(static_cast<double>(m.normal.y()), WithinAbs(-4 / root17, within));
    expect_point(m.points[0], 9.25, 5, 4.25 / root17, {vertex(0), face(2)}, 16 * within);
    expect_point(m.points[1], 12, 5, 7 / root17, {face(0), vertex(2)}, 16 * within);
    CHECK_THAT(static_cast<double>(m.points[0].depth), WithinAbs(1.030776, 1e-6));
    CHECK_THAT(static_cast<double>(m.points[1].depth), WithinAbs(1.697749, 1e-6));
  });
}
