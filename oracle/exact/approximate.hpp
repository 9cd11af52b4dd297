#pragma once

#include <cmath>
#include <optional>

#include "oracle/exact/double_double.hpp"

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

}  // namespace manifuzz::exact
