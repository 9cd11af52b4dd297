#include <cmath>

#include <catch2/catch.hpp>

#include "base/random.hpp"
#include "exact/root_sum.hpp"
#include "support/real.hpp"

// The number types of the judge, held against rationals.

namespace manifuzz::exact {
namespace {

Rational exactly(const DoubleDouble& value) {
  return Rational(value.high) + Rational(value.low);
}
Rational exactly(double value) {
  return Rational(value);
}

/// Doubles of all sizes within 2^+-40, some of them short, so that sums cancel and tie.
double draw(Random& random) {
  const double scale = std::ldexp(1.0, random.integer(-40, 40));
  const double digits = random.integer(-8, 7);
  return random.chance(0.5) ? digits : scale * (digits + random.unit());
}

template <class Real>
void check_encloses(const Approximate<Real>& got, const Rational& truth) {
  if (!std::isfinite(got.error)) return;
  CHECK(abs(exactly(got.value) - truth) <= Rational(got.error));
}

template <class Number>
void check_running_errors() {
  Random random(5, "numbers", 0);
  for (int i = 0; i < 20000; ++i) {
    const double x = draw(random);
    const double y = draw(random);
    const double z = draw(random);
    const Number a = Number(x) * Number(y) + Number(z);
    const Rational p = Rational(x) * Rational(y) + Rational(z);
    const Number b = Number(z) - Number(x) * Number(x);
    const Rational q = Rational(z) - Rational(x) * Rational(x);
    check_encloses(a * b, p * q);
    check_encloses(a - b, p - q);
    if (q != 0) check_encloses(a / b, p / q);
    check_encloses(sqrt(a * a), abs(p));
    if (const auto s = sign(a * b - a)) CHECK(*s == (p * q - p).sign());
  }
}

}  // namespace

TEST_CASE("running errors in double enclose the truth") {
  check_running_errors<Approximate<double>>();
}

TEST_CASE("running errors in pairs of doubles enclose the truth") {
  check_running_errors<Approximate<DoubleDouble>>();
}

TEST_CASE("pairs of doubles are well past double") {
  Random random(6, "numbers", 0);
  for (int i = 0; i < 2000; ++i) {
    const double x = 1 + random.unit();
    const double y = 2 + random.unit();
    const DoubleDouble root = sqrt(DoubleDouble(x) * DoubleDouble(y));
    const Rational off = abs(exactly(root * root) - Rational(x) * Rational(y));
    CHECK(off <= Rational(0x1p-98));
    const Rational quotient =
        abs(exactly(DoubleDouble(x) / DoubleDouble(y)) - Rational(x) / Rational(y));
    CHECK(quotient <= Rational(0x1p-101));
  }
}

TEST_CASE("an expansion has the sign of its rational, or none") {
  Random random(7, "numbers", 0);
  int known = 0;
  for (int i = 0; i < 20000; ++i) {
    const double x = draw(random);
    const double y = draw(random);
    const double z = draw(random);
    const Expansion a = Expansion(x) * Expansion(y) - Expansion(z);
    const Rational p = Rational(x) * Rational(y) - Rational(z);
    const Expansion difference = a * a - (Expansion(z) * Expansion(z) + Expansion(x));
    const Rational truth = p * p - (Rational(z) * Rational(z) + Rational(x));
    if (const auto s = sign(difference)) {
      CHECK(*s == truth.sign());
      ++known;
    }
    const auto zero = sign(a * a - a * a);
    if (zero) CHECK(*zero == 0);
  }
  CHECK(known > 15000);
}

TEST_CASE("an expansion beyond the range of double is lost") {
  CHECK(!sign(Expansion(0x1p-600) * Expansion(0x1p-600)));
  CHECK(!sign(Expansion(0x1p600) * Expansion(0x1p600)));
  CHECK(*sign(Expansion(0x1p-300) * Expansion(0x1p-300)) == 1);
}

TEST_CASE("the sign of a sum of three roots is the twin's") {
  Random random(8, "numbers", 0);
  for (int i = 0; i < 3000; ++i) {
    std::array<double, 6> x{};
    for (double& number : x) number = random.integer(-6, 6);
    for (const std::size_t r : {1, 3, 5}) x[r] = std::abs(x[r]);
    if (random.chance(0.3)) x[5] = 4 * x[1] + x[3];
    const auto sum = [&]<class Number>() {
      return RootSum<Number>{{{Number(x[0]), Number(x[1])},
                              {Number(x[2]), Number(x[3])},
                              {Number(x[4]), Number(x[5])}}};
    };
    const auto term = [&](std::size_t k) { return Real(x[k]) * square_root(Ratio(x[k + 1])); };
    const int truth = sign(term(0) + term(2) + term(4));
    CHECK(*sign(sum.operator()<Rational>()) == truth);
    CHECK(*sign(sum.operator()<Expansion>()) == truth);
    CHECK(decide(sum) == truth);
    if (const auto s = sign(sum.operator()<Approximate<double>>())) CHECK(*s == truth);
  }
}

}  // namespace manifuzz::exact
