#include "oracle/libccd/ledger/simplex.hpp"

#include <algorithm>
#include <type_traits>

namespace manifuzz::ledger_of {
namespace {

/// ccdEq, of what is rounded to the scalar.
template <class Scalar>
bool equal_of(double one, double other) {
  constexpr Scalar epsilon = std::numeric_limits<Scalar>::epsilon();
  const auto a = static_cast<Scalar>(one);
  const auto b = static_cast<Scalar>(other);
  const Scalar apart = std::abs(a - b);
  return apart < epsilon || apart < epsilon * std::max(std::abs(a), std::abs(b));
}

template <class Scalar>
bool are_equal(const CcdVectorOf<Scalar>& a, const CcdVectorOf<Scalar>& b) {
  return equal_of<Scalar>(a.x(), b.x()) && equal_of<Scalar>(a.y(), b.y()) &&
         equal_of<Scalar>(a.z(), b.z());
}

template <class Scalar>
int ccd_sign(Scalar value) {
  if (ccd_is_zero(value)) return 0;
  return value < 0 ? -1 : 1;
}

template <class Scalar>
bool is_zero_or_more(Scalar value) {
  return ccd_is_zero(value) || value > 0;
}

template <class Scalar>
bool is_one_or_less(double value) {
  return equal_of<Scalar>(value, 1) || value < 1;
}

template <class Scalar>
CcdVectorOf<Scalar> twice_crossed(const CcdVectorOf<Scalar>& a, const CcdVectorOf<Scalar>& b) {
  return ccd_cross<Scalar>(ccd_cross<Scalar>(a, b), a);
}

template <class Scalar>
bool is_origin_on(const CcdVectorOf<Scalar>& a, const CcdVectorOf<Scalar>& b,
                  const CcdVectorOf<Scalar>& c) {
  return ccd_is_zero(
      nearest_of_triangle<Scalar>(CcdVectorOf<Scalar>::Zero(), a, b, c, false).square);
}

template <class Scalar>
int step_of_two(CcdSimplexOf<Scalar>& simplex, CcdVectorOf<Scalar>& dir) {
  const CcdVectorOf<Scalar> a = simplex.corners[1];
  const CcdVectorOf<Scalar> ab = simplex.corners[0] - a;
  const CcdVectorOf<Scalar> ao = a * Scalar(-1);
  const Scalar along = ccd_dot(ab, ao);
  const CcdVectorOf<Scalar> area = ccd_cross(ab, ao);
  if (ccd_is_zero(ccd_dot(area, area)) && along > 0) return 1;
  if (ccd_is_zero(along) || along < 0) {
    simplex.set({a});
    dir = ao;
  } else {
    dir = twice_crossed(ab, ao);
  }
  return 0;
}

/// Beyond the edge from A to B, or beyond A.
template <class Scalar>
int step_beyond_edge(CcdSimplexOf<Scalar>& simplex, CcdVectorOf<Scalar>& dir,
                     const CcdVectorOf<Scalar>& a, const CcdVectorOf<Scalar>& b) {
  const CcdVectorOf<Scalar> ao = a * Scalar(-1);
  const CcdVectorOf<Scalar> ab = b - a;
  if (is_zero_or_more(ccd_dot(ab, ao))) {
    simplex.set({b, a});
    dir = twice_crossed(ab, ao);
  } else {
    simplex.set({a});
    dir = ao;
  }
  return 0;
}

template <class Scalar>
int step_of_three(CcdSimplexOf<Scalar>& simplex, CcdVectorOf<Scalar>& dir) {
  const auto [c, b, a, unused] = simplex.corners;
  if (is_origin_on(a, b, c)) return 1;
  if (are_equal<Scalar>(a, b) || are_equal<Scalar>(a, c)) return -1;
  const CcdVectorOf<Scalar> ao = a * Scalar(-1);
  const CcdVectorOf<Scalar> ab = b - a;
  const CcdVectorOf<Scalar> ac = c - a;
  const CcdVectorOf<Scalar> abc = ccd_cross(ab, ac);
  if (is_zero_or_more(ccd_dot(ccd_cross(abc, ac), ao))) {
    if (!is_zero_or_more(ccd_dot(ac, ao))) return step_beyond_edge(simplex, dir, a, b);
    simplex.set({c, a});
    dir = twice_crossed(ac, ao);
    return 0;
  }
  if (is_zero_or_more(ccd_dot(ccd_cross(ab, abc), ao))) {
    return step_beyond_edge(simplex, dir, a, b);
  }
  dir = abc;
  if (is_zero_or_more(ccd_dot(abc, ao))) return 0;
  simplex.set({b, c, a});
  dir = abc * Scalar(-1);
  return 0;
}

template <class Scalar>
int step_of_four(CcdSimplexOf<Scalar>& simplex, CcdVectorOf<Scalar>& dir) {
  const auto [d, c, b, a] = simplex.corners;
  if (ccd_is_zero(nearest_of_triangle<Scalar>(a, b, c, d, false).square)) return -1;
  if (is_origin_on(a, b, c) || is_origin_on(a, c, d) || is_origin_on(a, b, d) ||
      is_origin_on(b, c, d)) {
    return 1;
  }
  const CcdVectorOf<Scalar> ao = a * Scalar(-1);
  const CcdVectorOf<Scalar> ab = b - a;
  const CcdVectorOf<Scalar> ac = c - a;
  const CcdVectorOf<Scalar> ad = d - a;
  const auto is_same_side = [&](const CcdVectorOf<Scalar>& normal,
                                const CcdVectorOf<Scalar>& corner) {
    return ccd_sign(ccd_dot(normal, ao)) == ccd_sign(ccd_dot(normal, corner));
  };
  const bool with_b = is_same_side(ccd_cross(ac, ad), ab);
  const bool with_c = is_same_side(ccd_cross(ad, ab), ac);
  const bool with_d = is_same_side(ccd_cross(ab, ac), ad);
  if (with_b && with_c && with_d) return 1;
  if (!with_b) {
    simplex.set({d, c, a});
  } else if (!with_c) {
    simplex.set({b, d, a});
  } else {
    simplex.set({c, b, a});
  }
  return step_of_three(simplex, dir);
}

}  // namespace

bool ccd_equal(double a, double b) {
  return equal_of<double>(a, b);
}

bool ccd_equal(const CcdVector& a, const CcdVector& b) {
  return are_equal<double>(a, b);
}

template <class Scalar>
CcdNearestOf<Scalar> nearest_of_segment(const CcdVectorOf<Scalar>& from,
                                        const CcdVectorOf<Scalar>& a, const CcdVectorOf<Scalar>& b,
                                        bool with_place) {
  const CcdVectorOf<Scalar> d = b - a;
  const CcdVectorOf<Scalar> to_a = a - from;
  const Scalar t = -ccd_dot(to_a, d) / ccd_dot(d, d);
  const auto at = [&](const CcdVectorOf<Scalar>& place) {
    const CcdVectorOf<Scalar> apart = place - from;
    return CcdNearestOf<Scalar>{ccd_dot(apart, apart), place};
  };
  if (t < 0 || ccd_is_zero(t)) return at(a);
  if (t > 1 || equal_of<Scalar>(t, 1)) return at(b);
  if (with_place) return at(d * t + a);
  const CcdVectorOf<Scalar> apart = d * t + to_a;
  return {ccd_dot(apart, apart), a};
}

template <class Scalar>
CcdNearestOf<Scalar> nearest_of_triangle(const CcdVectorOf<Scalar>& from,
                                         const CcdVectorOf<Scalar>& x, const CcdVectorOf<Scalar>& b,
                                         const CcdVectorOf<Scalar>& c, bool with_place) {
  const CcdVectorOf<Scalar> d1 = b - x;
  const CcdVectorOf<Scalar> d2 = c - x;
  const CcdVectorOf<Scalar> a = x - from;
  const double u = ccd_dot(a, a);
  const double v = ccd_dot(d1, d1);
  const double w = ccd_dot(d2, d2);
  const double p = ccd_dot(a, d1);
  const double q = ccd_dot(a, d2);
  const double r = ccd_dot(d1, d2);
  const double area = w * v - r * r;
  // Bullet's copy is from before the test of the area.
  const bool is_flat = std::is_same_v<Scalar, double> && ccd_is_zero(area);
  const double s = is_flat ? -1 : (q * r - w * p) / area;
  const double t = is_flat ? -1 : (-s * r - q) / w;
  const auto is_not_below = [](double value) {
    return ccd_is_zero(static_cast<Scalar>(value)) || value > 0;
  };
  if (is_not_below(s) && is_one_or_less<Scalar>(s) && is_not_below(t) &&
      is_one_or_less<Scalar>(t) && is_one_or_less<Scalar>(t + s)) {
    const CcdVectorOf<Scalar> place = x + d1 * static_cast<Scalar>(s) + d2 * static_cast<Scalar>(t);
    const CcdVectorOf<Scalar> apart = place - from;
    if (with_place) return {ccd_dot(apart, apart), place, true};
    const double square = s * s * v + t * t * w + 2.0 * s * t * r + 2.0 * s * p + 2.0 * t * q + u;
    return {static_cast<Scalar>(square), x};
  }
  CcdNearestOf<Scalar> best = nearest_of_segment<Scalar>(from, x, b, with_place);
  for (const CcdNearestOf<Scalar>& other :
       {nearest_of_segment<Scalar>(from, x, c), nearest_of_segment<Scalar>(from, b, c)}) {
    if (other.square < best.square) best = other;
  }
  return best;
}

template <class Scalar>
int step_simplex(CcdSimplexOf<Scalar>& simplex, CcdVectorOf<Scalar>& dir) {
  if (simplex.size == 2) return step_of_two(simplex, dir);
  return simplex.size == 3 ? step_of_three(simplex, dir) : step_of_four(simplex, dir);
}

template CcdNearest nearest_of_segment(const CcdVector&, const CcdVector&, const CcdVector&, bool);
template CcdNearest nearest_of_triangle(const CcdVector&, const CcdVector&, const CcdVector&,
                                        const CcdVector&, bool);
template int step_simplex(CcdSimplexOf<double>&, CcdVectorOf<double>&);
template int step_simplex(CcdSimplexOf<float>&, CcdVectorOf<float>&);

}  // namespace manifuzz::ledger_of
