#pragma once

#include <array>
#include <cmath>
#include <optional>

namespace manifuzz::exact {

// Sums and products of doubles without loss, and the arithmetic of pairs of doubles built on them.

/// high + low, |low| <= ulp(high) / 2: 106 bits of significand.
struct DoubleDouble {
  double high = 0;
  double low = 0;

  constexpr DoubleDouble() = default;
  constexpr DoubleDouble(double value) : high(value) {}  // NOLINT(google-explicit-constructor)
  constexpr DoubleDouble(double h, double l) : high(h), low(l) {}
};

/// a + b exactly (Knuth 1969), whatever their order of size; no overflow assumed.
inline DoubleDouble two_sum(double a, double b) {
  const double sum = a + b;
  const double of_b = sum - a;
  return {sum, (a - (sum - of_b)) + (b - of_b)};
}

/// a + b exactly where |a| >= |b| or a is 0 (Dekker 1971).
inline DoubleDouble fast_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// a * b exactly, unless its last bit lies below the smallest double.
inline DoubleDouble two_product(double a, double b) {
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

// Relative errors, with u = 2^-53, by Joldes, Muller and Popescu, "Tight and rigorous error bounds
// for basic building blocks of double-word arithmetic" (2017), and, for the root, by Lefevre,
// Louvet, Muller, Picot and Rideau, "Accurate calculation of Euclidean norms using double-word
// arithmetic" (2023).

/// AccurateDWPlusDW: 3 u^2 / (1 - 4 u).
inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble high = two_sum(a.high, b.high);
  const DoubleDouble low = two_sum(a.low, b.low);
  const DoubleDouble first = fast_two_sum(high.high, high.low + low.high);
  return fast_two_sum(first.high, low.low + first.low);
}

inline DoubleDouble operator-(const DoubleDouble& a) {
  return {-a.high, -a.low};
}

inline DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) {
  return a + -b;
}

/// DWTimesDW3: 4 u^2.
inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble high = two_product(a.high, b.high);
  const double cross = std::fma(a.high, b.low, std::fma(a.low, b.high, a.low * b.low));
  return fast_two_sum(high.high, high.low + cross);
}

/// DWDivDW2: 15 u^2 + 56 u^3.
inline DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
  const double first = a.high / b.high;
  const DoubleDouble exact = two_product(b.high, first);
  const DoubleDouble back = fast_two_sum(exact.high, std::fma(b.low, first, exact.low));
  const double rest = (a.high - back.high) + (a.low - back.low);
  return fast_two_sum(first, rest / b.high);
}

/// SQRTDWtoDW: 25/8 u^2. Of a value that is not negative.
inline DoubleDouble sqrt(const DoubleDouble& a) {
  if (!(a.high > 0)) return {};
  const double first = std::sqrt(a.high);
  const double rest = std::fma(-first, first, a.high) + a.low;
  return fast_two_sum(first, rest / (2 * first));
}

/// An exact sum of doubles that do not overlap, the largest last (Shewchuk, "Adaptive precision
/// floating-point arithmetic", 1997). Cheap where numbers are short, as in exact ties on a grid;
/// a value of more terms than it holds, or beyond the range of double, is lost: it has no sign,
/// and rationals decide.
class Expansion {
 public:
  Expansion() = default;
  Expansion(double value) {  // NOLINT(google-explicit-constructor)
    if (value != 0) append(value);
  }

  friend Expansion operator+(const Expansion& a, const Expansion& b) {
    Expansion sum = a;
    sum.lost_ = a.lost_ || b.lost_;
    for (int i = 0; i < b.count_ && !sum.lost_; ++i) sum.grow(b.terms_[i]);
    return sum;
  }

  friend Expansion operator-(const Expansion& a) {
    Expansion negative = a;
    for (int i = 0; i < a.count_; ++i) negative.terms_[i] = -a.terms_[i];
    return negative;
  }

  friend Expansion operator-(const Expansion& a, const Expansion& b) { return a + -b; }

  friend Expansion operator*(const Expansion& a, const Expansion& b) {
    Expansion product;
    product.lost_ = a.lost_ || b.lost_;
    for (int i = 0; i < a.count_ && !product.lost_; ++i) {
      for (int j = 0; j < b.count_ && !product.lost_; ++j) {
        product.add_product(a.terms_[i], b.terms_[j]);
      }
    }
    return product;
  }

  /// -1, 0 or 1, or none where the value is lost.
  friend std::optional<int> sign(const Expansion& a) {
    if (a.lost_) return std::nullopt;
    if (a.count_ == 0) return 0;
    return a.terms_[a.count_ - 1] > 0 ? 1 : -1;
  }

 private:
  static constexpr int kCapacity = 24;
  /// Products of this size keep their last bit above the smallest double.
  static constexpr double kSmallestProduct = 0x1p-960;

  void append(double term) {
    if (count_ == kCapacity || !std::isfinite(term)) {
      lost_ = true;
    } else {
      terms_[count_++] = term;
    }
  }

  /// GROW-EXPANSION with zero elimination.
  void grow(double term) {
    const int before = count_;
    count_ = 0;
    for (int i = 0; i < before; ++i) {
      const DoubleDouble sum = two_sum(term, terms_[i]);
      term = sum.high;
      if (sum.low != 0) append(sum.low);
    }
    if (term != 0) append(term);
  }

  void add_product(double a, double b) {
    const DoubleDouble product = two_product(a, b);
    if (std::abs(product.high) < kSmallestProduct) lost_ = true;
    if (product.low != 0) grow(product.low);
    grow(product.high);
  }

  std::array<double, kCapacity> terms_;
  int count_ = 0;
  bool lost_ = false;
};

}  // namespace manifuzz::exact
