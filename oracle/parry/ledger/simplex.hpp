#pragma once

#include <array>
#include <utility>

#include "oracle/parry/ledger/shapes.hpp"

namespace manifuzz::parry {

/// A place on a segment or a triangle: on its vertex `first`, or between `first` and `second`.
template <class Real>
struct Projection {
  Vector2<Real> point{0, 0};
  int vertex_count = 1;  ///< of those it is between; 3 inside of a triangle
  int first = 0;
  int second = 0;
  std::array<Real, 2> shares{1, 0};  ///< of both vertices
};

/// Segment::project_local_point_and_get_location.
template <class Real>
Projection<Real> project_on_segment(const Vector2<Real>& place, const Vector2<Real>& a,
                                    const Vector2<Real>& b) {
  const Vector2<Real> ab = b - a;
  const Real before = ab.dot(place - a);
  const Real square = ab.dot(ab);
  if (before <= 0) return {.point = a};
  if (before >= square) return {.point = b, .first = 1};
  const Real share = before / square;
  return {.point = a + ab * share,
          .vertex_count = 2,
          .first = 0,
          .second = 1,
          .shares = {Real(1) - share, share}};
}

/// The origin's projection onto the edge from `corners[first]` to `corners[second]` of a triangle.
template <class Real>
Projection<Real> on_edge(const std::array<Vector2<Real>, 3>& corners, int first, int second,
                         Real before) {
  const Vector2<Real>& from = corners[static_cast<std::size_t>(first)];
  const Vector2<Real> along = corners[static_cast<std::size_t>(second)] - from;
  const Real share = before / along.dot(along);
  return {.point = from + along * share,
          .vertex_count = 2,
          .first = first,
          .second = second,
          .shares = {Real(1) - share, share}};
}

/// The origin's projection onto a triangle without area: onto its longest edge.
template <class Real>
Projection<Real> origin_on_longest_edge(const std::array<Vector2<Real>, 3>& corners) {
  const auto square = [&](std::size_t i, std::size_t j) {
    const Vector2<Real> along = corners[j] - corners[i];
    return along.dot(along);
  };
  std::array ends{0, 1};
  if (!(square(0, 1) >= square(0, 2) && square(0, 1) >= square(1, 2))) {
    ends = square(0, 2) >= square(1, 2) ? std::array{0, 2} : std::array{1, 2};
  }
  Projection<Real> found =
      project_on_segment<Real>(Vector2<Real>(0, 0), corners[static_cast<std::size_t>(ends[0])],
                               corners[static_cast<std::size_t>(ends[1])]);
  found.first = ends[static_cast<std::size_t>(found.first)];
  found.second = ends[1];
  return found;
}

/// Triangle::project_local_point_and_get_location of the origin, solid.
template <class Real>
Projection<Real> project_origin_on_triangle(const std::array<Vector2<Real>, 3>& corners) {
  const auto& [a, b, c] = corners;
  const Vector2<Real> ab = b - a;
  const Vector2<Real> ac = c - a;
  const Vector2<Real> bc = c - b;
  const Vector2<Real> origin(0, 0);
  const Vector2<Real> ap = origin - a;
  const Vector2<Real> bp = origin - b;
  const Vector2<Real> cp = origin - c;
  const Real ab_ap = ab.dot(ap);
  const Real ac_ap = ac.dot(ap);
  if (ab_ap <= 0 && ac_ap <= 0) return {.point = a};
  const Real ab_bp = ab.dot(bp);
  const Real ac_bp = ac.dot(bp);
  if (ab_bp >= 0 && ac_bp <= ab_bp) return {.point = b, .first = 1};
  const Real ab_cp = ab.dot(cp);
  const Real ac_cp = ac.dot(cp);
  if (ac_cp >= 0 && ab_cp <= ac_cp) return {.point = c, .first = 2};
  const Real n = cross(ab, ac);
  const Real vc = n * cross(ab, ap);
  if (vc < 0 && ab_ap >= 0 && ab_bp <= 0) return on_edge(corners, 0, 1, ab_ap);
  const Real vb = -n * cross(ac, cp);
  if (vb < 0 && ac_ap >= 0 && ac_cp <= 0) return on_edge(corners, 0, 2, ac_ap);
  const Real va = n * cross(bc, bp);
  if (va < 0 && ac_bp - ab_bp >= 0 && ab_cp - ac_cp >= 0) {
    return on_edge(corners, 1, 2, bc.dot(bp));
  }
  if (va + vb + vc == 0) return origin_on_longest_edge(corners);
  return {.point = origin, .vertex_count = 3};
}

/// The origin's place on the line through two corners by products without roundings: what is left
/// of them is of the place's own length. parry does not do so.
template <class Real>
Vector2<Real> unrounded_foot(const Vector2<Real>& from, const Vector2<Real>& to) {
  const Real left = from.x() * to.y();
  const Real right = from.y() * to.x();
  const Real left_rest = std::fma(from.x(), to.y(), -left);
  const Real right_rest = std::fma(from.y(), to.x(), -right);
  const Vector2<Real> along = to - from;
  const Vector2<Real> across(along.y(), -along.x());
  return across * (((left - right) + (left_rest - right_rest)) / along.dot(along));
}

/// VoronoiSimplex of voronoi_simplex2.rs.
template <class Real>
class Simplex {
 public:
  /// `tolerance`: the square of a length, below which two corners are taken for one.
  explicit Simplex(const Corner<Real>& corner, Real tolerance = kGjkTolerance<Real>)
      : tolerance_(tolerance) {
    corners_[0] = corner;
  }

  int count() const { return count_; }
  const Corner<Real>& corner(int i) const { return corners_[static_cast<std::size_t>(i)]; }

  /// False where it has it, or one that is nearer than the root of the tolerance.
  bool add(const Corner<Real>& corner) {
    previous_count_ = count_;
    previous_shares_ = shares_;
    previous_ = {0, 1, 2};
    for (int i = 0; i < count_; ++i) {
      const Vector2<Real> apart = this->corner(i).point - corner.point;
      if (apart.isZero(0) || apart.dot(apart) < tolerance_) {
        refused_ = length_of(apart);
        return false;
      }
    }
    corners_[static_cast<std::size_t>(count_++)] = corner;
    return true;
  }

  /// How far the corner that it refused last is from the one that it has.
  Real refused() const { return refused_; }

  /// project_origin_and_reduce.
  Vector2<Real> nearest_to_origin() {
    const Projection<Real> found = projected();
    if (found.vertex_count == 3) return found.point;
    if (found.vertex_count == 1) {
      swap(0, found.first);
      shares_[0] = 1;
      count_ = 1;
      return found.point;
    }
    shares_ = found.shares;
    if (found.first == 1) {
      swap(0, 2);
      std::swap(shares_[0], shares_[1]);
    } else if (found.second == 2) {
      swap(1, 2);
    }
    count_ = 2;
    return found.point;
  }

  /// gjk.rs: result, the nearest points on A and B, of what it was before its last corner too.
  std::pair<Vector2<Real>, Vector2<Real>> nearest(bool is_previous) const {
    Vector2<Real> on_a(0, 0);
    Vector2<Real> on_b(0, 0);
    for (int i = 0; i < (is_previous ? previous_count_ : count_); ++i) {
      const auto at = static_cast<std::size_t>(i);
      const Real share = is_previous ? previous_shares_[at] : shares_[at];
      const Corner<Real>& from = corners_[is_previous ? previous_[at] : at];
      on_a += from.on_a * share;
      on_b += from.on_b * share;
    }
    return {on_a, on_b};
  }

 private:
  Projection<Real> projected() const {
    if (count_ == 1) return {.point = corners_[0].point};
    if (count_ == 2) {
      return project_on_segment<Real>(Vector2<Real>(0, 0), corners_[0].point, corners_[1].point);
    }
    return project_origin_on_triangle<Real>(
        {corners_[0].point, corners_[1].point, corners_[2].point});
  }
  void swap(int i, int j) {
    std::swap(corners_[static_cast<std::size_t>(i)], corners_[static_cast<std::size_t>(j)]);
    std::swap(previous_[static_cast<std::size_t>(i)], previous_[static_cast<std::size_t>(j)]);
  }

  std::array<Corner<Real>, 3> corners_{};
  std::array<Real, 2> shares_{};
  int count_ = 1;
  std::array<std::size_t, 3> previous_{0, 1, 2};
  std::array<Real, 2> previous_shares_{};
  int previous_count_ = 1;
  Real refused_ = 0;
  Real tolerance_;
};

}  // namespace manifuzz::parry
