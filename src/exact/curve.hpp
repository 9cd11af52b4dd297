#pragma once

#include <array>
#include <optional>
#include <vector>

#include "exact/truth.hpp"

namespace manifuzz::exact {

// How deep two bodies overlap, direction by direction. R is the total radius, W the difference of
// both cores: every a - b, seen from the world. n is a unit normal that points from A to B.
//
//   D(n) = h_A(n) + h_B(-n)   the depth along n: the largest n . w, plus R. B leaves A when it is
//                             moved by so much along n; negative where they are apart along n.
//   D*                        the least of all D(n): the penetration depth.
//   G(n)                      the deepest overlap on any line along n: the largest s for which s n
//                             is in W, plus R. G(n) <= D(n), and they are equal where D is least.

/// What the radii add to both cores: a skin whose corners are as sharp as theirs, so that faces
/// alone tell how deep they overlap (Box2D 2.4), or one that is round at corners.
enum class Skin { mitred, round };

/// The skin of a pair: round where either shape is.
inline Skin skin_of(const Truth& truth) {
  return is_round(truth.pair()) ? Skin::round : Skin::mitred;
}

/// What the curve says at one normal.
class Along {
 public:
  /// `normal` in A's frame; its direction alone counts. Finite, and not zero. The truth must
  /// outlive it.
  Along(const Truth& truth, const Vector2<double>& normal);

  /// As it was given.
  const Vector2<double>& local_normal() const { return normal_; }

  /// D(n), a world length, as near as double says it.
  double depth() const;
  /// The sign of D(n) - length.
  int compare_depth(double length) const;

  /// Whether any line along the normal meets both cores, B slid by up to so much along the tangent;
  /// G(n) is minus infinity where none does.
  bool meets(double slide = 0) const { return compare_reach(-slide) >= 0; }
  double gap() const;
  /// The sign of G(n) - length, at its largest where B is slid by up to so much along the tangent:
  /// where corners pass each other G depends on rounding alone.
  int compare_gap(double length, double slide = 0) const;
  /// As `compare_gap`, but with B slid to where G(n) is least.
  int compare_least_gap(double length, double slide) const;

  /// The normal in the world, with the length that the numbers have.
  template <class Number>
  Point<Number> normal() const {
    return turned(pair().a, Point<Number>{Number(normal_.x()), Number(normal_.y())});
  }
  /// The largest n . w over the cores, times that length.
  template <class Number>
  Number scaled_support() const {
    return dot(normal<Number>(), vertex<Number>(pair(), Side::a, farthest_of_a_) -
                                     vertex<Number>(pair(), Side::b, nearest_of_b_));
  }

 private:
  const StoredPair& pair() const { return truth_->stored(); }
  /// The sign of (how far W reaches past the line through the origin, on both sides) - length.
  int compare_reach(double length) const;
  std::vector<FaceOf> faces_ahead() const;
  int compare_ahead(double length, double slide) const;

  const Truth* truth_;
  Vector2<double> normal_;
  int farthest_of_a_ = 0;      ///< the vertex farthest along the normal
  int nearest_of_b_ = 0;       ///< the vertex least far along it
  std::vector<FaceOf> ahead_;  ///< W's faces that look along the normal
};

/// The curve of a pair. The truth must outlive it.
class PenetrationCurve {
 public:
  PenetrationCurve(const Truth& truth, Skin skin);
  /// As if this face had the least depth.
  PenetrationCurve(const Truth& truth, FaceOf face)
      : truth_(&truth), face_(face), is_apart_(false) {}

  /// D*, as near as double says it.
  double least() const;
  /// The sign of D* - length.
  int compare_least(double length) const;
  /// The sign of D(n) - D* - bound.
  int compare_excess(const Along& along, double bound) const;
  double excess(const Along& along) const { return along.depth() - least(); }

  /// The unit normals, in A's frame, of every least value of D that is within `bound` of D*; the
  /// least of all is the first. Of two points at one place every normal is one: (1, 0).
  std::vector<Vector2<double>> minima(double bound) const;

  /// Whether the skin is round and the cores do not overlap: D* is then the total radius less their
  /// distance.
  bool are_cores_apart() const { return is_apart_; }
  /// The vertices of cores that are apart, A's and B's, where they are nearest; none where a face
  /// and a vertex are.
  std::optional<std::array<int, 2>> nearest_vertices() const { return vertices_; }
  /// The face of the greatest separation, where there is one.
  FaceOf face() const { return face_; }

 private:
  /// How far the cores are apart where they are nearest: root / divisor. Negative: how deep they
  /// overlap.
  template <class Number>
  struct Apart {
    Root<Number> root;
    Number divisor;
  };
  template <class Number>
  Apart<Number> apart() const;
  template <class Number>
  Point<Number> between_vertices() const;
  Vector2<double> unit_normal(FaceOf face) const;
  const StoredPair& pair() const { return truth_->stored(); }

  const Truth* truth_;
  FaceOf face_;  ///< of the greatest separation
  bool is_apart_;
  bool are_at_one_place_ = false;               ///< the nearest vertices
  std::optional<std::array<int, 2>> vertices_;  ///< A's and B's nearest, where no face decides
};

/// S of the pair, to well past double; of round shapes whose cores are apart, their distance.
double separation_of(const Truth& truth);

/// The angles at which to draw the curve, in radians from 0, ascending: every two degrees, which
/// nobody sees, and where the curve has corners.
std::vector<double> angles_to_draw(const RoughPair& placed);

}  // namespace manifuzz::exact
