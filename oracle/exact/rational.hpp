#pragma once

#include <boost/multiprecision/gmp.hpp>
#include <optional>

namespace manifuzz::exact {

/// Every float, and every sum, product and quotient of floats.
using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational,
                                               boost::multiprecision::et_off>;

inline std::optional<int> sign(const Rational& a) {
  return a.sign();
}

}  // namespace manifuzz::exact
