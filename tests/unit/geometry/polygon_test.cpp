#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <catch2/catch.hpp>

#include "geometry/convex_polygon.hpp"

using namespace manifuzz;

namespace {

using Outline = std::vector<Vector2<float>>;

ConvexPolygon<float> polygon(const Outline& outline, float radius = 0) {
  REQUIRE(find_defect(outline) == std::nullopt);
  return make_polygon<float>(outline, radius);
}

/// How far a normal may lie from the truth: half a unit in the last place, and the roundings before
/// the last, which are done in double.
template <class Scalar>
long double half_ulp(long double value) {
  const Scalar magnitude = static_cast<Scalar>(std::abs(value));
  const Scalar above = std::nextafter(magnitude, std::numeric_limits<Scalar>::infinity());
  return (static_cast<long double>(above) - magnitude) / 2;
}

/// Checks the normal of one edge against its definition in long double.
template <class Scalar>
void check_normal(const Vector2<Scalar>& from, const Vector2<Scalar>& to) {
  const Vector2<Scalar> normal = outward_normal(from, to);
  const long double dx = static_cast<long double>(to.x()) - from.x();
  const long double dy = static_cast<long double>(to.y()) - from.y();
  const long double length = std::sqrt(dx * dx + dy * dy);
  const long double true_x = dy / length;
  const long double true_y = -dx / length;
  CAPTURE(from.x(), from.y(), to.x(), to.y(), normal.x(), normal.y());
  const long double doubles = 4 * 0x1p-53L;  // the roundings before the last, in double
  CHECK(std::abs(normal.x() - true_x) <= half_ulp<Scalar>(true_x) + doubles * std::abs(true_x));
  CHECK(std::abs(normal.y() - true_y) <= half_ulp<Scalar>(true_y) + doubles * std::abs(true_y));
  const long double x = normal.x();
  const long double y = normal.y();
  const long double u = std::numeric_limits<Scalar>::epsilon() / 2;
  CHECK(std::abs(std::sqrt(x * x + y * y) - 1) <= u + doubles);
}

}  // namespace

TEST_CASE("the normals of a box point outward, exactly") {
  const auto box = polygon({{-1, -1}, {2, -1}, {2, 1}, {-1, 1}});
  CHECK(box.count == 4);
  CHECK(box.normals[0] == Vector2<float>(0, -1));
  CHECK(box.normals[1] == Vector2<float>(1, 0));
  CHECK(box.normals[2] == Vector2<float>(0, 1));
  CHECK(box.normals[3] == Vector2<float>(-1, 0));
}

TEST_CASE("normals are right to half a unit in the last place") {
  std::mt19937_64 bits(1);
  const auto draw = [&bits](int exponent) {
    const double unit = static_cast<double>(bits() >> 11) * 0x1p-52 - 1;
    return static_cast<float>(std::ldexp(unit, exponent));
  };
  for (int n = 0; n < 5000; ++n) {
    const int exponent = static_cast<int>(bits() % 250) - 125;
    const int slope = static_cast<int>(bits() % 20);
    const Vector2<float> from(draw(exponent), draw(exponent - slope));
    const Vector2<float> to(draw(exponent), draw(exponent - slope));
    if (from == to) continue;
    check_normal<float>(from, to);
    check_normal<double>(from.cast<double>(), to.cast<double>());
  }
}

TEST_CASE("a float normal is the unit direction rounded, also next to where rounding turns over") {
  std::mt19937_64 bits(3);
  const auto high = [](double x) { return static_cast<float>(x); };
  const auto low = [](double x) {
    return static_cast<float>(static_cast<double>(static_cast<float>(x)) - x);
  };
  int near = 0;
  for (int n = 0; n < 20'000; ++n) {
    const auto mantissa = static_cast<double>((bits() >> 41) | (1U << 23U));
    const double between = (mantissa + 0.5) * 0x1p-24;  // two floats
    const double other = std::sqrt(1 - between * between);
    const Vector2<float> from(low(between), low(other));
    const Vector2<float> to(high(between), high(other));
    const Vector2<double> edge = to.cast<double>() - from.cast<double>();
    const Vector2<double> direction = clockwise_quarter(unit_direction(edge));
    near += std::abs(-direction.y() - between) < 0x1p-50 ? 1 : 0;
    REQUIRE(outward_normal(from, to) == direction.cast<float>());
  }
  CHECK(near > 1000);
}

TEST_CASE("a unit direction is within two roundoffs of the true one") {
  std::mt19937_64 bits(2);
  const auto draw = [&bits] { return static_cast<double>(bits() >> 11) * 0x1p-52 - 1; };
  for (int n = 0; n < 100'000; ++n) {
    const int slope = static_cast<int>(bits() % 20);
    const Vector2<double> v(draw(), std::ldexp(draw(), -slope));
    const Vector2<double> direction = unit_direction(v);
    const long double x = v.x();
    const long double y = v.y();
    const long double length = std::sqrt(x * x + y * y);
    const long double off_x = direction.x() - x / length;
    const long double off_y = direction.y() - y / length;
    CAPTURE(v.x(), v.y());
    REQUIRE(std::sqrt(off_x * off_x + off_y * off_y) <= 2.01L * 0x1p-53L);
  }
}

TEST_CASE("normals neither over- nor underflow") {
  constexpr float tiny = std::numeric_limits<float>::denorm_min();
  constexpr float huge = std::numeric_limits<float>::max();
  check_normal<float>({0, 0}, {tiny, tiny});
  check_normal<float>({0, 0}, {tiny, 0});
  check_normal<float>({-huge, -huge}, {huge, huge});
  check_normal<float>({-huge, 0}, {huge, tiny});
  check_normal<double>({0, 0}, {1e-300, 3e-300});
  check_normal<double>({-1e300, 0}, {1e300, 3e300});
}

TEST_CASE("each vertex lies inside every other face") {
  const auto p = polygon({{12, 0}, {4, 12}, {-6, 11}, {-11, -3}, {1, -12}});
  for (int face = 0; face < p.count; ++face) {
    for (int i = 0; i < p.count; ++i) {
      if (i == face || i == p.next(face)) continue;
      CHECK(p.normals[face].dot(p.vertices[i] - p.vertices[face]) < 0);
    }
  }
}

TEST_CASE("next and previous go round") {
  const auto triangle = polygon({{0, 0}, {1, 0}, {0, 1}});
  CHECK(triangle.next(0) == 1);
  CHECK(triangle.next(2) == 0);
  CHECK(triangle.previous(0) == 2);
  CHECK(triangle.previous(2) == 1);
  CHECK(triangle.corners().size() == 3);
}

TEST_CASE("a cast polygon has the same vertices, and normals of its own scalar") {
  const auto p = polygon({{0, 0}, {3, 1}, {1, 3}}, 0.25F);
  const auto wide = polygon_cast<double>(p);
  CHECK(wide.count == 3);
  CHECK(wide.radius == 0.25);
  for (int i = 0; i < 3; ++i)
    CHECK(wide.vertices[i] == Vector2<double>(p.vertices[i].cast<double>()));
  CHECK(wide.normals[0] != Vector2<double>(p.normals[0].cast<double>()));
  CHECK(std::abs(wide.normals[0].norm() - 1) < 1e-15);
  CHECK(polygon_cast<float>(wide) == p);
}

TEST_CASE("polygons are equal by vertices in order, and radius") {
  const auto p = polygon({{0, 0}, {1, 0}, {0, 1}}, 0.5F);
  CHECK(p == polygon({{0, 0}, {1, 0}, {0, 1}}, 0.5F));
  CHECK_FALSE(p == polygon({{0, 0}, {1, 0}, {0, 1}}));
  CHECK_FALSE(p == polygon({{1, 0}, {0, 1}, {0, 0}}, 0.5F));
  CHECK_FALSE(p == polygon({{0, 0}, {1, 0}, {0, 2}}, 0.5F));
  CHECK_FALSE(p == polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 0.5F));
}

TEST_CASE("a placed polygon moves with its normals") {
  const auto p = polygon({{-1, -1}, {2, -1}, {2, 1}, {-1, 1}}, 0.5F);
  const auto placed = transform(Pose<float>{{10, 20}, {0, 1}}, p);  // a quarter turn, then (10, 20)
  CHECK(placed == polygon({{11, 19}, {11, 22}, {9, 22}, {9, 19}}, 0.5F));
  CHECK(placed.normals[0] == Vector2<float>(1, 0));
  CHECK(placed.normals[3] == Vector2<float>(0, -1));
}

TEST_CASE("the diameter is the largest distance between two vertices") {
  CHECK(diameter(polygon({{0, 0}, {3, 0}, {3, 4}})) == 5);
  CHECK(diameter(polygon({{10, 10}, {13, 10}, {13, 14}, {10, 14}})) == 5);
  CHECK(diameter(polygon({{-4, 0}, {0, -1}, {4, 0}, {0, 1}})) == 8);
}

TEST_CASE("the reach is the largest distance of a vertex from the polygon's origin") {
  CHECK(reach(polygon({{0, 0}, {3, 0}, {3, 4}})) == 5);
  CHECK(reach(polygon({{-4, -3}, {1, 0}, {0, 1}})) == 5);
  CHECK(reach(polygon({{100, 0}, {101, 0}, {100, 1}})) == 101);
}

TEST_CASE("diameter and reach hold the largest and the smallest floats") {
  constexpr float tiny = std::numeric_limits<float>::denorm_min();
  constexpr float huge = std::numeric_limits<float>::max();
  const auto large = polygon({{-huge, -huge}, {huge, -huge}, {-huge, huge}});
  CHECK(diameter(large) == Approx(2 * std::sqrt(2.0) * huge));
  CHECK(reach(large) == Approx(std::sqrt(2.0) * huge));
  const auto small = polygon({{0, 0}, {tiny, 0}, {0, tiny}});
  CHECK(diameter(small) == Approx(std::sqrt(2.0) * tiny).margin(0));
  CHECK(reach(small) == tiny);
}
