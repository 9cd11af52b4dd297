#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "exact/arithmetic.hpp"
#include "exact/rational.hpp"

namespace manifuzz::exact {

inline double leading(double value) {
  return value;
}
inline double leading(const DoubleDouble& value) {
  return value.high;
}

/// The relative error of one operation on `Real`, at most.
template <class Real>
inline constexpr double kRoundoff = 0x1p-53;
template <>
inline constexpr double kRoundoff<DoubleDouble> = 0x1p-101;  // 15 u^2 + 56 u^3 < 2^5 u^2

/// A number known to within a proven error: |truth - value| <= error. The filter of every exact
/// decision. Each operation adds its own rounding to what it inherits (running error analysis,
/// Higham, "Accuracy and Stability", 3.3).
template <class Real>
struct Approximate {
  Real value{0};
  double error = 0;

  Approximate() = default;
  Approximate(double exact) : value(exact) {}  // NOLINT(google-explicit-constructor)
  Approximate(const Real& v, double e) : value(v), error(e) {}
};

namespace detail {

/// Errors are computed in rounded doubles themselves: at most eight roundings each, 2^-53 apiece.
inline constexpr double kSlack = 1 + 0x1p-49;
/// What an operation may lose to underflow, of all its parts together.
inline constexpr double kUnderflow = 0x1p-1000;

template <class Real>
Approximate<Real> rounded(const Real& value, double inherited) {
  return {value, kSlack * (inherited + kRoundoff<Real> * std::abs(leading(value))) + kUnderflow};
}

}  // namespace detail

template <class Real>
Approximate<Real> operator+(const Approximate<Real>& a, const Approximate<Real>& b) {
  return detail::rounded<Real>(a.value + b.value, a.error + b.error);
}

template <class Real>
Approximate<Real> operator-(const Approximate<Real>& a, const Approximate<Real>& b) {
  return detail::rounded<Real>(a.value - b.value, a.error + b.error);
}

template <class Real>
Approximate<Real> operator-(const Approximate<Real>& a) {
  return {-a.value, a.error};
}

template <class Real>
Approximate<Real> operator*(const Approximate<Real>& a, const Approximate<Real>& b) {
  const double of_a = std::abs(leading(a.value)) * detail::kSlack;
  const double of_b = std::abs(leading(b.value)) * detail::kSlack;
  return detail::rounded<Real>(a.value * b.value, of_a * b.error + (of_b + b.error) * a.error);
}

/// |a/b - x/y| <= (|x/y| db + da) / (|y| - db): unbounded where y may be zero.
template <class Real>
Approximate<Real> operator/(const Approximate<Real>& a, const Approximate<Real>& b) {
  const double divisor = std::abs(leading(b.value)) / detail::kSlack - b.error;
  if (!(divisor > 0)) return {Real(0), INFINITY};
  const Real quotient = a.value / b.value;
  const double of_quotient = std::abs(leading(quotient)) * detail::kSlack;
  return detail::rounded<Real>(quotient,
                               detail::kSlack * ((of_quotient * b.error + a.error) / divisor));
}

/// |sqrt(a) - sqrt(x)| <= da / sqrt(x). The truth is not negative.
template <class Real>
Approximate<Real> sqrt(const Approximate<Real>& a) {
  using std::sqrt;
  if (!(leading(a.value) > a.error)) {
    const double most = sqrt(std::abs(leading(a.value)) * detail::kSlack + a.error);
    return {Real(0), most * detail::kSlack};
  }
  const Real root = sqrt(a.value);
  return detail::rounded<Real>(root, detail::kSlack * (a.error / leading(root)));
}

/// -1, 0 or 1, where the error leaves no doubt.
template <class Real>
std::optional<int> sign(const Approximate<Real>& a) {
  const double value = leading(a.value);
  if (std::abs(value) > a.error) return value > 0 ? 1 : -1;
  if (value == 0 && a.error == 0) return 0;
  return std::nullopt;
}

// The sign of a sum of square roots: what every comparison of lengths and angles is in the end.

/// coefficient * sqrt(radicand), radicand >= 0.
template <class Number>
struct Root {
  Number coefficient = Number(0.0);
  Number radicand = Number(1.0);
};

/// The sum of up to three.
template <class Number>
using RootSum = std::array<Root<Number>, 3>;

template <class Number>
RootSum<Number> sum_of(const Root<Number>& one, const Root<Number>& two = {},
                       const Root<Number>& three = {}) {
  return {one, two, three};
}

namespace detail {

/// The sign of a sqrt(p) + b sqrt(q): where the signs differ, the greater square decides.
template <class Number>
std::optional<int> sign_of_two(const Root<Number>& a, const Root<Number>& b) {
  const auto of_a = sign(a.coefficient * a.radicand);
  const auto of_b = sign(b.coefficient * b.radicand);
  if (!of_a || !of_b) return std::nullopt;
  if (*of_a == 0) return *of_b;
  if (*of_b == 0 || *of_a == *of_b) return *of_a;
  const auto greater =
      sign(a.coefficient * a.coefficient * a.radicand - b.coefficient * b.coefficient * b.radicand);
  if (!greater) return std::nullopt;
  return *of_a * *greater;
}

}  // namespace detail

/// Exact, by sign and square; none where the numbers are lost.
template <class Number>
std::optional<int> sign(const RootSum<Number>& sum) {
  const auto& [a, b, c] = sum;
  const auto of_two = detail::sign_of_two(a, b);
  const auto of_c = sign(c.coefficient * c.radicand);
  if (!of_two || !of_c) return std::nullopt;
  if (*of_two == 0) return *of_c;
  if (*of_c == 0 || *of_two == *of_c) return *of_two;
  // (a sqrt(p) + b sqrt(q))^2 - c^2 r, which is a rational and 2 a b sqrt(p q).
  const Root<Number> rational{a.coefficient * a.coefficient * a.radicand +
                              b.coefficient * b.coefficient * b.radicand -
                              c.coefficient * c.coefficient * c.radicand};
  const Root<Number> mixed{Number(2.0) * a.coefficient * b.coefficient, a.radicand * b.radicand};
  const auto greater = detail::sign_of_two(rational, mixed);
  if (!greater) return std::nullopt;
  return *of_two * *greater;
}

/// By its value, where the error leaves no doubt.
template <class Real>
std::optional<int> sign(const RootSum<Approximate<Real>>& sum) {
  Approximate<Real> value;
  for (const auto& root : sum) {
    if (leading(root.coefficient.value) == 0 && root.coefficient.error == 0) continue;
    value = value + root.coefficient * sqrt(root.radicand);
  }
  return sign(value);
}

/// The sign of what `expression` (called with a number type) builds, once a filter in doubles has
/// left it open: expansions settle exact ties of short numbers, pairs of doubles what is no tie,
/// rationals the rest.
template <class Expression>
int decide(const Expression& expression) {
  if (const auto s = sign(expression.template operator()<Expansion>())) return *s;
  if (const auto s = sign(expression.template operator()<Approximate<DoubleDouble>>())) return *s;
  return *sign(expression.template operator()<Rational>());
}

/// As `decide`, but tries the expression in doubles first.
template <class Expression>
int decide_from_doubles(const Expression& expression) {
  const auto s = sign(expression.template operator()<Approximate<double>>());
  return s ? *s : decide(expression);
}

/// rational + root * sqrt(radicand): the field in which everything about one reference face lives,
/// its radicand being the square of the face's length.
struct Quadratic {
  Rational rational{0};
  Rational root{0};
  Rational radicand{0};

  Quadratic() = default;
  explicit Quadratic(double value) : rational(value) {}
  Quadratic(Rational q, Rational r, Rational d)
      : rational(std::move(q)), root(std::move(r)), radicand(std::move(d)) {}

  friend Quadratic operator+(const Quadratic& a, const Quadratic& b) {
    return {a.rational + b.rational, a.root + b.root, common_radicand(a, b)};
  }
  friend Quadratic operator-(const Quadratic& a, const Quadratic& b) {
    return {a.rational - b.rational, a.root - b.root, common_radicand(a, b)};
  }
  friend Quadratic operator*(const Quadratic& a, const Quadratic& b) {
    const Rational common = common_radicand(a, b);
    return {a.rational * b.rational + a.root * b.root * common,
            a.rational * b.root + a.root * b.rational, common};
  }

  /// A rational's is zero.
  static const Rational& common_radicand(const Quadratic& a, const Quadratic& b) {
    return a.radicand.is_zero() ? b.radicand : a.radicand;
  }
};

inline std::optional<int> sign(const Quadratic& a) {
  return sign(RootSum<Rational>{{{a.rational, Rational(1)}, {a.root, a.radicand}, {}}});
}

/// What rational + root * sqrt(radicand) is in a number type: a number, where it has roots, ...
template <class Real>
Approximate<Real> with_root(const Approximate<Real>& rational, const Approximate<Real>& root,
                            const Approximate<Real>& radicand) {
  return rational + root * sqrt(radicand);
}

/// ... and an element of the field, where it has none.
inline Quadratic with_root(const Rational& rational, const Rational& root,
                           const Rational& radicand) {
  return {rational, root, radicand};
}

template <class Number>
struct ElementOf {
  using type = Number;
};
template <>
struct ElementOf<Rational> {
  using type = Quadratic;
};
template <class Number>
using Element = typename ElementOf<Number>::type;

}  // namespace manifuzz::exact
