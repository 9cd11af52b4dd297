#include "judging/ledger/bullet/ccd_simplex.hpp"

namespace manifuzz::ledger_of {
namespace {

int ccd_sign(double value) {
  if (ccd_is_zero(value)) return 0;
  return value < 0 ? -1 : 1;
}

bool is_zero_or_more(double value) {
  return ccd_is_zero(value) || value > 0;
}

bool is_one_or_less(double value) {
  return ccd_equal(value, 1) || value < 1;
}

CcdVector twice_crossed(const CcdVector& a, const CcdVector& b) {
  return ccd_cross(ccd_cross(a, b), a);
}

bool is_origin_on(const CcdVector& a, const CcdVector& b, const CcdVector& c) {
  return ccd_is_zero(nearest_of_triangle(CcdVector::Zero(), a, b, c, false).square);
}

int step_of_two(CcdSimplex& simplex, CcdVector& dir) {
  const CcdVector a = simplex.corners[1];
  const CcdVector ab = simplex.corners[0] - a;
  const CcdVector ao = -a;
  const double along = ccd_dot(ab, ao);
  const CcdVector area = ccd_cross(ab, ao);
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
int step_beyond_edge(CcdSimplex& simplex, CcdVector& dir, const CcdVector& a, const CcdVector& b) {
  const CcdVector ao = -a;
  const CcdVector ab = b - a;
  if (is_zero_or_more(ccd_dot(ab, ao))) {
    simplex.set({b, a});
    dir = twice_crossed(ab, ao);
  } else {
    simplex.set({a});
    dir = ao;
  }
  return 0;
}

int step_of_three(CcdSimplex& simplex, CcdVector& dir) {
  const auto [c, b, a, unused] = simplex.corners;
  if (is_origin_on(a, b, c)) return 1;
  if (ccd_equal(a, b) || ccd_equal(a, c)) return -1;
  const CcdVector ao = -a;
  const CcdVector ab = b - a;
  const CcdVector ac = c - a;
  const CcdVector abc = ccd_cross(ab, ac);
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
  dir = abc * -1.0;
  return 0;
}

int step_of_four(CcdSimplex& simplex, CcdVector& dir) {
  const auto [d, c, b, a] = simplex.corners;
  if (ccd_is_zero(nearest_of_triangle(a, b, c, d, false).square)) return -1;
  if (is_origin_on(a, b, c) || is_origin_on(a, c, d) || is_origin_on(a, b, d) ||
      is_origin_on(b, c, d)) {
    return 1;
  }
  const CcdVector ao = -a;
  const CcdVector ab = b - a;
  const CcdVector ac = c - a;
  const CcdVector ad = d - a;
  const auto is_same_side = [&](const CcdVector& normal, const CcdVector& corner) {
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
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const double apart = std::abs(a - b);
  return apart < epsilon || apart < epsilon * std::max(std::abs(a), std::abs(b));
}

bool ccd_equal(const CcdVector& a, const CcdVector& b) {
  return ccd_equal(a.x(), b.x()) && ccd_equal(a.y(), b.y()) && ccd_equal(a.z(), b.z());
}

CcdNearest nearest_of_segment(const CcdVector& from, const CcdVector& a, const CcdVector& b,
                              bool with_place) {
  const CcdVector d = b - a;
  const CcdVector to_a = a - from;
  const double t = -1.0 * ccd_dot(to_a, d) / ccd_dot(d, d);
  const auto at = [&](const CcdVector& place) {
    const CcdVector apart = place - from;
    return CcdNearest{ccd_dot(apart, apart), place};
  };
  if (t < 0 || ccd_is_zero(t)) return at(a);
  if (t > 1 || ccd_equal(t, 1)) return at(b);
  if (with_place) return at(d * t + a);
  const CcdVector apart = d * t + to_a;
  return {ccd_dot(apart, apart), a};
}

CcdNearest nearest_of_triangle(const CcdVector& from, const CcdVector& x, const CcdVector& b,
                               const CcdVector& c, bool with_place) {
  const CcdVector d1 = b - x;
  const CcdVector d2 = c - x;
  const CcdVector a = x - from;
  const double u = ccd_dot(a, a);
  const double v = ccd_dot(d1, d1);
  const double w = ccd_dot(d2, d2);
  const double p = ccd_dot(a, d1);
  const double q = ccd_dot(a, d2);
  const double r = ccd_dot(d1, d2);
  const double area = w * v - r * r;
  const double s = ccd_is_zero(area) ? -1 : (q * r - w * p) / area;
  const double t = ccd_is_zero(area) ? -1 : (-s * r - q) / w;
  if (is_zero_or_more(s) && is_one_or_less(s) && is_zero_or_more(t) && is_one_or_less(t) &&
      is_one_or_less(t + s)) {
    const CcdVector place = x + d1 * s + d2 * t;
    const CcdVector apart = place - from;
    if (with_place) return {ccd_dot(apart, apart), place};
    return {s * s * v + t * t * w + 2.0 * s * t * r + 2.0 * s * p + 2.0 * t * q + u, x};
  }
  CcdNearest best = nearest_of_segment(from, x, b, with_place);
  for (const CcdNearest& other : {nearest_of_segment(from, x, c), nearest_of_segment(from, b, c)}) {
    if (other.square < best.square) best = other;
  }
  return best;
}

void CcdSimplex::set(std::initializer_list<CcdVector> some) {
  size = 0;
  for (const CcdVector& corner : some) add(corner);
}

int step_simplex(CcdSimplex& simplex, CcdVector& dir) {
  if (simplex.size == 2) return step_of_two(simplex, dir);
  return simplex.size == 3 ? step_of_three(simplex, dir) : step_of_four(simplex, dir);
}

}  // namespace manifuzz::ledger_of
