#pragma once

#include <array>
#include <optional>

#include "oracle/exact/approximate.hpp"
#include "oracle/exact/expansion.hpp"
#include "oracle/exact/rational.hpp"

// The sign of a sum of square roots: what every comparison of lengths and angles is in the end.

namespace manifuzz::exact {

/// coefficient * sqrt(radicand), radicand >= 0.
template <class Number>
struct Root {
  Number coefficient = Number(0.0);
  Number radicand = Number(1.0);
};

/// The sum of up to three.
template <class Number>
using RootSum = std::array<Root<Number>, 3>;

namespace detail {

/// Of a sqrt(p) + b sqrt(q): where the signs differ, the greater square decides.
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

}  // namespace manifuzz::exact
