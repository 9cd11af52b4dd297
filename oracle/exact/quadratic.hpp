#pragma once

#include <optional>
#include <utility>

#include "oracle/exact/root_sum.hpp"

namespace manifuzz::exact {

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
