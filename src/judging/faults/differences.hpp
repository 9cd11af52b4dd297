#pragma once

#include <vector>

#include "exact/placed.hpp"
#include "judging/ledger.hpp"

namespace manifuzz::ledger_of {

using exact::distance_to_segment;
using exact::nearest_on_segment;

/// The convex hull of every a - b of both cores, in world directions: they overlap where the origin
/// is in it, and B is moved away by a vector that takes the origin out of it.
class Difference {
 public:
  explicit Difference(const PairCase& pair);

  /// Counter-clockwise.
  const std::vector<Vector2<double>>& corners() const { return corners_; }
  const Vector2<double>& after(std::size_t i) const { return corners_[(i + 1) % corners_.size()]; }
  /// How far it goes along a vector, times the vector's length.
  double reach(const Vector2<double>& along) const;
  /// Its corner that is farthest along a vector.
  const Vector2<double>& farthest(const Vector2<double>& along) const;
  /// How far a place is outside of it; 0 inside.
  double distance_from(const Vector2<double>& place) const;

 private:
  std::vector<Vector2<double>> corners_;
};

/// In the world, the places on a side's core that are nearest to the other core's vertices, and its
/// own vertices.
std::vector<Vector2<double>> nearest_places(const PairCase& pair, Side side);

/// Whether what is wrong is where points lie, or how many there are: no matter of the translation.
bool is_of_points(Kind kind);
/// The deepest of its points' depths; 0 of none.
double deepest(const Manifold<double>& manifold);
/// The answer's normal, in the world, times the deepest of its depths.
Vector2<double> translation_of(const Deviation& deviation);
/// Whether the translation is that of a least depth, within `bound`, and yet it is wrong.
bool is_translation_right(const Deviation& deviation, double bound);
/// D* of the pair.
double least_depth(const Deviation& deviation);

}  // namespace manifuzz::ledger_of
