#pragma once

#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Core>

namespace manifuzz::ledger_of {

// The GJK of libccd in its own doubles, operation by operation: vec3.c, and doSimplex2 to
// doSimplex4 and __ccdGJK of ccd.c. In float it is the copy of these that begins
// btGjkPairDetector.cpp of Bullet.

template <class Scalar>
using CcdVectorOf = Eigen::Matrix<Scalar, 3, 1, Eigen::DontAlign>;
using CcdVector = CcdVectorOf<double>;

template <class Scalar>
Scalar ccd_dot(const CcdVectorOf<Scalar>& a, const CcdVectorOf<Scalar>& b) {
  return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

template <class Scalar>
CcdVectorOf<Scalar> ccd_cross(const CcdVectorOf<Scalar>& a, const CcdVectorOf<Scalar>& b) {
  return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
          a.x() * b.y() - a.y() * b.x()};
}

template <class Scalar>
bool ccd_is_zero(Scalar value) {
  return std::abs(value) < std::numeric_limits<Scalar>::epsilon();
}

bool ccd_equal(double a, double b);
bool ccd_equal(const CcdVector& a, const CcdVector& b);

/// A squared distance of the origin, and the place that it is of.
template <class Scalar>
struct CcdNearestOf {
  Scalar square = 0;
  CcdVectorOf<Scalar> place{0, 0, 0};
  bool is_within = false;  ///< a triangle, where it is asked with its place
};
using CcdNearest = CcdNearestOf<double>;

/// ccdVec3PointSegmentDist2 and ccdVec3PointTriDist2, with a witness or without: that is another
/// sum.
template <class Scalar>
CcdNearestOf<Scalar> nearest_of_segment(const CcdVectorOf<Scalar>& from,
                                        const CcdVectorOf<Scalar>& a, const CcdVectorOf<Scalar>& b,
                                        bool with_place = true);
template <class Scalar>
CcdNearestOf<Scalar> nearest_of_triangle(const CcdVectorOf<Scalar>& from,
                                         const CcdVectorOf<Scalar>& a, const CcdVectorOf<Scalar>& b,
                                         const CcdVectorOf<Scalar>& c, bool with_place = true);

/// The corners, the last one added last.
template <class Scalar>
struct CcdSimplexOf {
  std::array<CcdVectorOf<Scalar>, 4> corners{};
  int size = 0;

  void add(const CcdVectorOf<Scalar>& corner) { corners[size++] = corner; }
  void set(std::initializer_list<CcdVectorOf<Scalar>> some) {
    size = 0;
    for (const CcdVectorOf<Scalar>& corner : some) add(corner);
  }
};
using CcdSimplex = CcdSimplexOf<double>;

/// doSimplex: 1 where the origin is in it, -1 where they do not intersect, 0 to go on along `dir`.
template <class Scalar>
int step_simplex(CcdSimplexOf<Scalar>& simplex, CcdVectorOf<Scalar>& dir);

/// __ccdGJK: whether they intersect, with the simplex and the direction that it ends with.
template <class Scalar, class Support>
bool is_intersection(const Support& support, CcdSimplexOf<Scalar>& simplex,
                     CcdVectorOf<Scalar>& dir) {
  constexpr int iterations_max = 1000;
  simplex.add(support(CcdVectorOf<Scalar>(1, 0, 0)));
  dir = simplex.corners[0] * Scalar(-1);
  for (int i = 0; i < iterations_max; ++i) {
    const CcdVectorOf<Scalar> corner = support(dir);
    if (ccd_dot(corner, dir) < 0) return false;
    simplex.add(corner);
    const int result = step_simplex(simplex, dir);
    if (result == 1) return true;
    if (result == -1 || ccd_is_zero(ccd_dot(dir, dir))) return false;
  }
  return false;
}

}  // namespace manifuzz::ledger_of
