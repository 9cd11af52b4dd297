#pragma once

#include <boost/multiprecision/gmp.hpp>
#include <functional>
#include <memory>
#include <optional>

namespace manifuzz {

using Integer = boost::multiprecision::mpz_int;
using Ratio = boost::multiprecision::mpq_rational;

/// A real number between two multiples of 2^-bits.
struct Enclosure {
  Integer low;
  Integer high;
};

/// A real number as a procedure that encloses it as narrowly as it is asked to: slow, plain, and
/// nothing like the way in which the judge compares. A rational stays one.
class Real {
 public:
  Real(const Ratio& value);                   // NOLINT(google-explicit-constructor)
  Real(double value) : Real(Ratio(value)) {}  // NOLINT(google-explicit-constructor)

  const std::optional<Ratio>& rational() const { return node_->rational; }
  const Enclosure& at(unsigned bits) const;

  friend Real operator+(const Real& a, const Real& b);
  friend Real operator-(const Real& a, const Real& b);
  friend Real operator*(const Real& a, const Real& b);
  friend Real operator/(const Real& a, const Real& b);  ///< b is not zero
  friend Real square_root(const Ratio& value);          ///< of a value that is not negative

 private:
  struct Node {
    std::optional<Ratio> rational;
    std::function<Enclosure(unsigned)> enclose;
    unsigned bits = 0;  ///< of the last enclosure, which is kept
    Enclosure last;
  };
  explicit Real(std::function<Enclosure(unsigned)> enclose);

  std::shared_ptr<Node> node_;
};

Real square_root(const Ratio& value);

/// -1, 0 or 1. What cannot be told from zero in 2^14 bits is zero: sums of three roots of the
/// sizes that floats make are farther from zero or are zero (root separation).
int sign(const Real& value);

inline bool operator<(const Real& a, const Real& b) {
  return sign(a - b) < 0;
}
inline bool operator<=(const Real& a, const Real& b) {
  return sign(a - b) <= 0;
}

inline Real lesser(const Real& a, const Real& b) {
  return b < a ? b : a;
}
inline Real greater(const Real& a, const Real& b) {
  return a < b ? b : a;
}
inline Real magnitude(const Real& a) {
  return sign(a) < 0 ? Real(0.0) - a : a;
}

/// To the last digit or so.
double nearest(const Real& value);

}  // namespace manifuzz
