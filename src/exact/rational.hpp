#pragma once

#include <compare>
#include <optional>

#ifdef MANIFUZZ_WITHOUT_GMP
#include <boost/multiprecision/cpp_int.hpp>
#else
#include <gmp.h>
#endif

namespace manifuzz::exact {

#ifdef MANIFUZZ_WITHOUT_GMP
using Rational = boost::multiprecision::number<boost::multiprecision::cpp_rational_backend,
                                               boost::multiprecision::et_off>;
#else
/// Every float, and every sum, product and quotient of floats; divisors are not zero. GMP's own
/// rationals, for Boost's wrapper of them takes longer to compile than all else that judges.
class Rational {
 public:
  Rational() { mpq_init(value_); }
  Rational(double finite) : Rational() {  // NOLINT(google-explicit-constructor)
    mpq_set_d(value_, finite);
  }
  Rational(const Rational& other) : Rational() { mpq_set(value_, other.value_); }
  Rational(Rational&& other) noexcept : Rational() { mpq_swap(value_, other.value_); }
  ~Rational() { mpq_clear(value_); }

  Rational& operator=(const Rational& other) {
    mpq_set(value_, other.value_);  // which may be its own
    return *this;
  }
  Rational& operator=(Rational&& other) noexcept {
    mpq_swap(value_, other.value_);
    return *this;
  }

  /// -1, 0 or 1.
  int sign() const { return mpq_sgn(value_); }
  bool is_zero() const { return sign() == 0; }
  /// Towards zero.
  explicit operator double() const { return mpq_get_d(value_); }

  friend Rational operator+(const Rational& a, const Rational& b) { return of(mpq_add, a, b); }
  friend Rational operator-(const Rational& a, const Rational& b) { return of(mpq_sub, a, b); }
  friend Rational operator*(const Rational& a, const Rational& b) { return of(mpq_mul, a, b); }
  friend Rational operator/(const Rational& a, const Rational& b) { return of(mpq_div, a, b); }

  friend Rational operator-(Rational a) {
    mpq_neg(a.value_, a.value_);
    return a;
  }
  friend Rational abs(Rational a) {
    mpq_abs(a.value_, a.value_);
    return a;
  }

  friend bool operator==(const Rational& a, const Rational& b) {
    return mpq_equal(a.value_, b.value_) != 0;
  }
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
    return mpq_cmp(a.value_, b.value_) <=> 0;
  }

 private:
  template <class Operation>
  static Rational of(const Operation& operation, const Rational& a, const Rational& b) {
    Rational result;
    operation(result.value_, a.value_, b.value_);
    return result;
  }

  mpq_t value_;
};
#endif

inline std::optional<int> sign(const Rational& a) {
  return a.sign();
}

}  // namespace manifuzz::exact
