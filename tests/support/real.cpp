#include "support/real.hpp"

#include <algorithm>
#include <stdexcept>

namespace manifuzz {
namespace {

Integer floor_division(const Integer& a, const Integer& b) {
  Integer quotient;
  mpz_fdiv_q(quotient.backend().data(), a.backend().data(), b.backend().data());
  return quotient;
}

Integer ceiling_division(const Integer& a, const Integer& b) {
  Integer quotient;
  mpz_cdiv_q(quotient.backend().data(), a.backend().data(), b.backend().data());
  return quotient;
}

Integer power_of_two(unsigned bits) {
  return Integer(1) << bits;
}

/// The least and the greatest of four products or quotients.
template <class Combine>
Enclosure spanned(const Enclosure& a, const Enclosure& b, const Combine& combine) {
  const auto first = combine(a.low, b.low);
  Enclosure span{first.low, first.high};
  for (const Enclosure& other :
       {combine(a.low, b.high), combine(a.high, b.low), combine(a.high, b.high)}) {
    span.low = std::min(span.low, other.low);
    span.high = std::max(span.high, other.high);
  }
  return span;
}

Enclosure enclosed(const Ratio& value, unsigned bits) {
  const Integer above = numerator(value) << bits;
  const Integer below = denominator(value);
  return {floor_division(above, below), ceiling_division(above, below)};
}

}  // namespace

Real::Real(const Ratio& value) : node_(std::make_shared<Node>()) {
  node_->rational = value;
  node_->enclose = [value](unsigned bits) { return enclosed(value, bits); };
}

Real::Real(std::function<Enclosure(unsigned)> enclose) : node_(std::make_shared<Node>()) {
  node_->enclose = std::move(enclose);
}

const Enclosure& Real::at(unsigned bits) const {
  if (node_->bits != bits) {
    node_->last = node_->enclose(bits);
    node_->bits = bits;
  }
  return node_->last;
}

Real operator+(const Real& a, const Real& b) {
  if (a.rational() && b.rational()) return Ratio(*a.rational() + *b.rational());
  return Real([a, b](unsigned bits) {
    const Enclosure& p = a.at(bits);
    const Enclosure& q = b.at(bits);
    return Enclosure{p.low + q.low, p.high + q.high};
  });
}

Real operator-(const Real& a, const Real& b) {
  if (a.node_ == b.node_) return Ratio(0);
  if (a.rational() && b.rational()) return Ratio(*a.rational() - *b.rational());
  return Real([a, b](unsigned bits) {
    const Enclosure& p = a.at(bits);
    const Enclosure& q = b.at(bits);
    return Enclosure{p.low - q.high, p.high - q.low};
  });
}

Real operator*(const Real& a, const Real& b) {
  if (a.rational() && b.rational()) return Ratio(*a.rational() * *b.rational());
  return Real([a, b](unsigned bits) {
    const Integer unit = power_of_two(bits);
    return spanned(a.at(bits), b.at(bits), [&](const Integer& p, const Integer& q) {
      const Integer product = p * q;
      return Enclosure{floor_division(product, unit), ceiling_division(product, unit)};
    });
  });
}

Real operator/(const Real& a, const Real& b) {
  if (a.rational() && b.rational()) return Ratio(*a.rational() / *b.rational());
  return Real([a, b](unsigned bits) {
    // The divisor is not zero, and is enclosed away from it at some width.
    Enclosure divisor = b.at(bits);
    unsigned wider = bits;
    while (divisor.low <= 0 && divisor.high >= 0) {
      wider *= 2;
      if (wider > (1U << 16)) throw std::logic_error("division by what may be zero");
      divisor = b.at(wider);
    }
    const Enclosure& dividend = a.at(wider);
    const Enclosure quotient = spanned(dividend, divisor, [&](const Integer& p, const Integer& q) {
      const Integer above = p << wider;
      return Enclosure{floor_division(above, q), ceiling_division(above, q)};
    });
    const Integer surplus = power_of_two(wider - bits);
    return Enclosure{floor_division(quotient.low, surplus),
                     ceiling_division(quotient.high, surplus)};
  });
}

Real square_root(const Ratio& value) {
  const Ratio root(sqrt(numerator(value)), sqrt(denominator(value)));
  if (root * root == value) return root;
  return Real([value](unsigned bits) {
    const Enclosure square = enclosed(value, 2 * bits);
    return Enclosure{sqrt(square.low), sqrt(square.high) + 1};
  });
}

int sign(const Real& value) {
  if (value.rational()) return value.rational()->sign();
  for (const unsigned bits : {256U, 1024U, 1U << 14}) {
    const Enclosure& enclosure = value.at(bits);
    if (enclosure.low > 0) return 1;
    if (enclosure.high < 0) return -1;
  }
  return 0;
}

double nearest(const Real& value) {
  const Enclosure& enclosure = value.at(512);
  return static_cast<double>(Ratio(enclosure.low + enclosure.high, power_of_two(513)));
}

}  // namespace manifuzz
