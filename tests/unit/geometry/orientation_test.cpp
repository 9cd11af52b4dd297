#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include <catch2/catch.hpp>

#include "geometry/convex_polygon.hpp"

using namespace manifuzz;

namespace {

using Wide = __int128;

struct WholePoint {
  std::int64_t x;
  std::int64_t y;
};

/// The sign by integers alone. Exact for coordinates up to 2^61.
int sign_by_integers(const WholePoint& a, const WholePoint& b, const WholePoint& c) {
  const Wide left = Wide{a.x - c.x} * Wide{b.y - c.y};
  const Wide right = Wide{a.y - c.y} * Wide{b.x - c.x};
  return left > right ? 1 : left < right ? -1 : 0;
}

int sign_by_doubles(const Vector2<double>& a, const Vector2<double>& b, const Vector2<double>& c) {
  const double area = (a.x() - c.x()) * (b.y() - c.y()) - (a.y() - c.y()) * (b.x() - c.x());
  return area > 0 ? 1 : area < 0 ? -1 : 0;
}

/// All six orders of the corners: turning keeps the sign, swapping two flips it.
template <class Scalar>
bool all_orders_agree(const Vector2<Scalar>& a, const Vector2<Scalar>& b, const Vector2<Scalar>& c,
                      int sign) {
  return orientation(a, b, c) == sign && orientation(b, c, a) == sign &&
         orientation(c, a, b) == sign && orientation(b, a, c) == -sign &&
         orientation(a, c, b) == -sign && orientation(c, b, a) == -sign;
}

}  // namespace

TEST_CASE("orientation tells left from right from straight") {
  const Vector2<float> a(0, 0);
  const Vector2<float> b(1, 0);
  CHECK(all_orders_agree(a, b, Vector2<float>(0, 1), 1));
  CHECK(all_orders_agree(a, b, Vector2<float>(0, -1), -1));
  CHECK(all_orders_agree(a, b, Vector2<float>(7, 0), 0));
  CHECK(all_orders_agree(a, b, b, 0));
  CHECK(all_orders_agree(a, a, a, 0));
}

TEST_CASE("orientation is exact where plain doubles are not") {
  // Points a few ulps around (0.5, 0.5), against the line through (12, 12) and (24, 24): Kettner et
  // al., "Classroom examples of robustness problems in geometric computations".
  const Vector2<double> b(12, 12);
  const Vector2<double> c(24, 24);
  constexpr std::int64_t one = std::int64_t{1} << 53;
  int wrong = 0;
  int plain_wrong = 0;
  for (int i = -128; i < 128; ++i) {
    for (int j = -128; j < 128; ++j) {
      const WholePoint whole{one / 2 + i, one / 2 + j};
      const Vector2<double> a(std::ldexp(static_cast<double>(whole.x), -53),
                              std::ldexp(static_cast<double>(whole.y), -53));
      const int exact = sign_by_integers(whole, {12 * one, 12 * one}, {24 * one, 24 * one});
      if (!all_orders_agree(a, b, c, exact)) ++wrong;
      if (sign_by_doubles(a, b, c) != exact) ++plain_wrong;
    }
  }
  CHECK(wrong == 0);
  CHECK(plain_wrong > 10000);  // else the grid is too easy
}

TEST_CASE("orientation is exact on floats of mixed magnitudes, near a line and on it") {
  std::mt19937_64 bits(1);
  const auto draw = [&bits](int low, int high) {
    return low + static_cast<int>(bits() % static_cast<unsigned>(high - low + 1));
  };
  int wrong = 0;
  int counts[3] = {};
  for (int n = 0; n < 50000; ++n) {
    // b and c are multiples of one direction, so that a = (0, 0) is in line with both; then one
    // coordinate is moved by a unit of a far smaller magnitude, or none is.
    const std::int64_t dx = draw(-4095, 4095);
    const std::int64_t dy = draw(-4095, 4095);
    const std::int64_t p = draw(1, 4095);
    const std::int64_t q = draw(1, 4095);
    const int shift = draw(0, 35);
    WholePoint whole[3] = {
        {0, 0}, {(p * dx) << shift, (p * dy) << shift}, {(q * dx) << shift, (q * dy) << shift}};
    whole[0].x += draw(-1, 1);
    whole[0].y += draw(-1, 1);
    Vector2<float> v[3];
    const int scale = draw(-120, 40);
    for (int i = 0; i < 3; ++i) {
      v[i] = Vector2<float>(std::ldexp(static_cast<float>(whole[i].x), scale),
                            std::ldexp(static_cast<float>(whole[i].y), scale));
    }
    const int exact = sign_by_integers(whole[0], whole[1], whole[2]);
    ++counts[exact + 1];
    if (!all_orders_agree(v[0], v[1], v[2], exact)) ++wrong;
  }
  CHECK(wrong == 0);
  CHECK(counts[0] > 2500);
  CHECK(counts[1] > 2500);
  CHECK(counts[2] > 2500);
}

TEST_CASE("orientation is exact on doubles whose products are not") {
  std::mt19937_64 bits(1);
  const auto draw = [&bits](int power) {
    return static_cast<std::int64_t>(bits() >> (64 - power)) - (std::int64_t{1} << (power - 1));
  };
  const auto as_doubles = [](const WholePoint& p) {
    return Vector2<double>(static_cast<double>(p.x), static_cast<double>(p.y));
  };
  int wrong = 0;
  int plain_wrong = 0;
  for (int n = 0; n < 30000; ++n) {
    const WholePoint direction{draw(26), draw(26)};
    const std::int64_t p = draw(26);
    const std::int64_t q = draw(26);
    const WholePoint a{draw(52), draw(52)};
    const WholePoint b{a.x + p * direction.x + draw(2), a.y + p * direction.y + draw(2)};
    const WholePoint c{a.x + q * direction.x, a.y + q * direction.y};
    const int exact = sign_by_integers(a, b, c);
    if (!all_orders_agree(as_doubles(a), as_doubles(b), as_doubles(c), exact)) ++wrong;
    if (sign_by_doubles(as_doubles(a), as_doubles(b), as_doubles(c)) != exact) ++plain_wrong;
  }
  CHECK(wrong == 0);
  CHECK(plain_wrong > 30);  // else the points are too easy
}

TEST_CASE("orientation is exact from the smallest float to the largest") {
  constexpr float tiny = std::numeric_limits<float>::denorm_min();
  constexpr float huge = std::numeric_limits<float>::max();
  const float half = std::ldexp(huge, -1);
  const Vector2<float> origin(0, 0);
  CHECK(all_orders_agree(Vector2<float>(tiny, 0), Vector2<float>(half, half),
                         Vector2<float>(huge, huge), -1));
  CHECK(all_orders_agree(Vector2<float>(0, tiny), Vector2<float>(half, half),
                         Vector2<float>(huge, huge), 1));
  CHECK(all_orders_agree(Vector2<float>(tiny, 0x1p-30F), Vector2<float>(half, half),
                         Vector2<float>(huge, huge), 1));
  CHECK(all_orders_agree(origin, Vector2<float>(half, half), Vector2<float>(huge, huge), 0));
  CHECK(all_orders_agree(origin, Vector2<float>(tiny, 0), Vector2<float>(0, tiny), 1));
  CHECK(all_orders_agree(Vector2<float>(-huge, -huge), Vector2<float>(huge, -huge),
                         Vector2<float>(huge, huge), 1));
  CHECK(all_orders_agree(Vector2<float>(-huge, -huge), Vector2<float>(tiny, tiny),
                         Vector2<float>(huge, huge), 0));
  CHECK(all_orders_agree(Vector2<float>(-huge, -huge), Vector2<float>(tiny, 2 * tiny),
                         Vector2<float>(huge, huge), -1));
}
