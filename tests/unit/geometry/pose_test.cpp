#include "geometry/pose.hpp"

#include <cmath>
#include <limits>
#include <random>

#include <catch2/catch.hpp>

using namespace manifuzz;

namespace {

/// A unit rotation by the rational point of the circle, to the last figures of a double.
Vector2<double> rotation_by(double t) {
  return {(1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)};
}

double distance(const Vector2<double>& p, const Vector2<double>& q) {
  return (p - q).norm();
}

}  // namespace

TEST_CASE("a positive quarter turn takes x to y") {
  const Vector2<float> quarter(0, 1);
  CHECK(rotate(quarter, Vector2<float>(2, 0)) == Vector2<float>(0, 2));
  CHECK(rotate(quarter, Vector2<float>(0, 2)) == Vector2<float>(-2, 0));
  CHECK(rotate_back(quarter, Vector2<float>(0, 2)) == Vector2<float>(2, 0));
  CHECK(counter_clockwise_quarter(Vector2<float>(3, 5)) == rotate(quarter, Vector2<float>(3, 5)));
  CHECK(clockwise_quarter(Vector2<float>(3, 5)) == rotate_back(quarter, Vector2<float>(3, 5)));
}

TEST_CASE("cross is positive counter-clockwise") {
  CHECK(cross(Vector2<float>(2, 0), Vector2<float>(0, 3)) == 6);
  CHECK(cross(Vector2<float>(0, 3), Vector2<float>(2, 0)) == -6);
  CHECK(cross(Vector2<float>(2, 3), Vector2<float>(4, 6)) == 0);
}

TEST_CASE("rotating back inverts rotating, up to cos^2 + sin^2") {
  const Vector2<double> v(3, -7);
  for (int i = -8; i <= 8; ++i) {
    CAPTURE(i);
    const Vector2<double> rotation = rotation_by(0.37 * i);
    CHECK(distance(rotate_back(rotation, rotate(rotation, v)), v) < 1e-14);
    CHECK(distance(rotate(rotation, rotate_back(rotation, v)), v) < 1e-14);
  }
  const Vector2<double> twice(0, 2);
  CHECK(rotate_back(twice, rotate(twice, v)) == Vector2<double>(4 * v));
}

TEST_CASE("transform rotates, then moves") {
  const Pose<float> pose{{10, 20}, {0, 1}};
  CHECK(transform(pose, Vector2<float>(1, 0)) == Vector2<float>(10, 21));
  CHECK(transform(Pose<float>{}, Vector2<float>(1, 2)) == Vector2<float>(1, 2));
}

TEST_CASE("through the relative pose into A's frame, and on into the world, is B's pose") {
  std::mt19937 bits(1);
  std::uniform_real_distribution<double> draw(-3, 3);
  for (int n = 0; n < 100; ++n) {
    const Pose<double> a{{draw(bits), draw(bits)}, rotation_by(draw(bits))};
    const Pose<double> b{{draw(bits), draw(bits)}, rotation_by(draw(bits))};
    const Vector2<double> v(draw(bits), draw(bits));
    CHECK(distance(transform(a, transform(relative_pose(a, b), v)), transform(b, v)) < 1e-14);
  }
}

TEST_CASE("the relative pose of a pose to itself is the identity") {
  const Pose<float> pose{{3, 4}, {0.6F, 0.8F}};
  const Pose<float> relative = relative_pose(pose, pose);
  CHECK(relative.position == Vector2<float>(0, 0));
  CHECK(relative.rotation.x() == Approx(1));
  CHECK(relative.rotation.y() == 0);
}

TEST_CASE("the distance from the origin costs a relative pose nothing") {
  const Pose<float> a{{1e7F, -1e7F}, {0, 1}};
  const Pose<float> b{{1e7F + 1, -1e7F + 3}, {1, 0}};
  CHECK(relative_pose(a, b) == Pose<float>{{3, -1}, {0, -1}});
}

TEST_CASE("a rotation is unit within its tolerance") {
  CHECK(is_unit_rotation(Vector2<float>(1, 0)));
  CHECK(is_unit_rotation(Vector2<float>(0.6F, -0.8F)));
  CHECK(is_unit_rotation(Vector2<double>(1 + 4.9e-6, 0)));
  CHECK(is_unit_rotation(Vector2<double>(0, 1 - 4.9e-6)));
  CHECK_FALSE(is_unit_rotation(Vector2<double>(1 + 5.1e-6, 0)));
  CHECK_FALSE(is_unit_rotation(Vector2<double>(0, 1 - 5.1e-6)));
  CHECK_FALSE(is_unit_rotation(Vector2<float>(0, 0)));
  CHECK_FALSE(is_unit_rotation(Vector2<float>(1, 1)));
  CHECK_FALSE(is_unit_rotation(Vector2<float>(std::nanf(""), 0)));
  CHECK_FALSE(is_unit_rotation(Vector2<float>(0, std::numeric_limits<float>::infinity())));
  CHECK_FALSE(is_unit_rotation(Vector2<float>(std::numeric_limits<float>::max(), 0)));
}
