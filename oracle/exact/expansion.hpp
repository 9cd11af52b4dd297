#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "oracle/exact/double_double.hpp"

namespace manifuzz::exact {

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
