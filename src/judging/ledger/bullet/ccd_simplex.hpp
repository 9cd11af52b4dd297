#pragma once

#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Core>

namespace manifuzz::ledger_of {

// The GJK of libccd 2.1 in its own doubles, operation by operation: vec3.c, and doSimplex2 to
// doSimplex4 of ccd.c.

using CcdVector = Eigen::Matrix<double, 3, 1, Eigen::DontAlign>;

inline double ccd_dot(const CcdVector& a, const CcdVector& b) {
  return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

inline CcdVector ccd_cross(const CcdVector& a, const CcdVector& b) {
  return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
          a.x() * b.y() - a.y() * b.x()};
}

inline bool ccd_is_zero(double value) {
  return std::abs(value) < std::numeric_limits<double>::epsilon();
}

bool ccd_equal(double a, double b);
bool ccd_equal(const CcdVector& a, const CcdVector& b);

/// A squared distance of the origin, and the place that it is of.
struct CcdNearest {
  double square = 0;
  CcdVector place{0, 0, 0};
};

/// ccdVec3PointSegmentDist2 and ccdVec3PointTriDist2, with a witness or without: that is another
/// sum.
CcdNearest nearest_of_segment(const CcdVector& from, const CcdVector& a, const CcdVector& b,
                              bool with_place = true);
CcdNearest nearest_of_triangle(const CcdVector& from, const CcdVector& a, const CcdVector& b,
                               const CcdVector& c, bool with_place = true);

/// The corners, the last one added last.
struct CcdSimplex {
  std::array<CcdVector, 4> corners{};
  int size = 0;

  void add(const CcdVector& corner) { corners[size++] = corner; }
  void set(std::initializer_list<CcdVector> some);
};

/// doSimplex: 1 where the origin is in it, -1 where they do not intersect, 0 to go on along `dir`.
int step_simplex(CcdSimplex& simplex, CcdVector& dir);

}  // namespace manifuzz::ledger_of
