#include "geometry/orientation.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace manifuzz {
namespace {

/// A sum of doubles kept exactly, as terms that do not overlap and grow in magnitude.
struct Expansion {
  std::array<double, 12> terms{};
  int count = 0;

  /// Shewchuk's GROW-EXPANSION.
  void add(double value) {
    double carry = value;
    for (int i = 0; i < count; ++i) {
      const double sum = carry + terms[i];
      const double from_term = sum - carry;
      terms[i] = (carry - (sum - from_term)) + (terms[i] - from_term);
      carry = sum;
    }
    terms[count++] = carry;
  }

  void add_product(double x, double y) {
    const double product = x * y;
    add(product);
    add(std::fma(x, y, -product));
  }

  int sign() const {
    for (int i = count - 1; i >= 0; --i) {
      if (terms[i] != 0) return terms[i] > 0 ? 1 : -1;
    }
    return 0;
  }
};

int sign_by_expansion(const Vector2<double>& a, const Vector2<double>& b,
                      const Vector2<double>& c) {
  Expansion area;
  area.add_product(a.x(), b.y());
  area.add_product(-a.x(), c.y());
  area.add_product(b.x(), c.y());
  area.add_product(-b.x(), a.y());
  area.add_product(c.x(), a.y());
  area.add_product(-c.x(), b.y());
  return area.sign();
}

}  // namespace

int orientation(const Vector2<double>& a, const Vector2<double>& b, const Vector2<double>& c) {
  constexpr double u = std::numeric_limits<double>::epsilon() / 2;
  constexpr double filter = (3 + 16 * u) * u;  // Shewchuk's ccwerrboundA
  const double left = (a.x() - c.x()) * (b.y() - c.y());
  const double right = (a.y() - c.y()) * (b.x() - c.x());
  const double area = left - right;
  if (std::abs(area) > filter * (std::abs(left) + std::abs(right))) return area > 0 ? 1 : -1;
  return sign_by_expansion(a, b, c);
}

}  // namespace manifuzz
