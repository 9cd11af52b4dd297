#pragma once

#include <optional>
#include <vector>

#include "exact/fine_point.hpp"
#include "judging/by_curve.hpp"

namespace manifuzz {

// What is right of round shapes beyond the penetration curve: their normal where cores are apart.
// bounds.md derives the bounds.

/// How a normal stands to the direction in which cores that are apart are nearest.
class NearestNormal {
 public:
  /// `separation` and `normal`: the collider's bounds of these, a world length and of unit vectors.
  NearestNormal(const exact::Truth& truth, const exact::PenetrationCurve& curve, double separation,
                double normal);

  /// Whether cores are apart by more than rounding, so that their distance decides the depth.
  bool decides() const { return is_apart_ && distance_ > bound_of_separation_; }
  /// Whether a normal must be the nearest direction: not where a vertex is in front of the inside
  /// of a face, or cores are about to touch, for there the excess of its depth says more.
  bool must_be_near() const {
    return decides() && !is_inside_face_ && distance_ > 2 * bound_of_separation_;
  }
  /// Whether a normal may be near the nearest direction, whatever its excess.
  bool may_be_near() const { return decides() && !is_inside_face_; }
  /// Whether the error of a normal is within its bound.
  bool is_near(const Vector2<double>& normal) const;
  /// |n - n*|, the normal in A's frame; n* is also that of any face with a vertex in front of it,
  /// and of any two vertices, whose distance rounding cannot tell from the least.
  double error(const Vector2<double>& normal) const;
  /// Each n* that `error` knows, unit, in the world, some of them twice. Only where a normal may be
  /// near one.
  std::vector<exact::FinePoint> directions() const;
  /// How much of that is rounding.
  double bound() const;

 private:
  double off(const Vector2<double>& normal, const exact::FinePoint& right) const;
  /// The directions of faces and vertices that rounding cannot tell from the nearest.
  std::vector<exact::FinePoint> as_near() const;

  const exact::Truth* truth_;
  double bound_of_separation_;
  double bound_of_normal_;
  bool is_apart_;
  double distance_ = 0;
  bool is_inside_face_ = false;
  exact::FinePoint direction_{};  ///< in the world, unit
};

}  // namespace manifuzz
