#pragma once

#include <array>

#include "oracle/bullet/ledger/prisms.hpp"

namespace manifuzz::ledger_of {

/// A corner of the difference, and what it is made of.
struct DifferenceCorner {
  Space w{0, 0, 0};
  Space on_a{0, 0, 0};
  Space on_b{0, 0, 0};
};

/// btVoronoiSimplexSolver: the closest point of up to four corners to the origin.
class VoronoiSimplex {
 public:
  /// inSimplex: whether a corner is in it, or nearer to one that is than
  /// VORONOI_DEFAULT_EQUAL_VERTEX_THRESHOLD.
  bool holds(const Space& w) const;
  /// Whether it is there only by that threshold.
  bool holds_another(const Space& w) const;
  /// addVertex, and updateClosestVectorAndPoints of what is there then: false where it fails.
  bool add(const DifferenceCorner& corner);
  bool is_full() const { return count_ == 4; }
  /// The closest point: what it is made of, and the vector between.
  const DifferenceCorner& closest() const { return closest_; }

 private:
  struct Weights {
    std::array<float, 4> of{};
    std::array<bool, 4> used{};
    bool is_valid() const;
  };
  Weights of_segment() const;
  static Weights of_triangle(const Space& a, const Space& b, const Space& c, Space* place);
  /// False where the origin is inside, or the corners are in a plane.
  bool find_tetrahedron(Weights& weights);
  void make_closest(const Weights& weights);
  void reduce(const Weights& weights);

  std::array<DifferenceCorner, 5> corners_{};
  int count_ = 0;
  Space last_{1e18F, 1e18F, 1e18F};
  DifferenceCorner closest_;
  bool is_degenerate_ = false;  // pointOutsideOfPlane found four corners in a plane, within 0.0001
};

}  // namespace manifuzz::ledger_of
