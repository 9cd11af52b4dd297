#pragma once

#include <vector>

#include "collider/sequence_collider.hpp"
#include "judging/extent.hpp"
#include "measure/referee.hpp"

namespace manifuzz {

/// What an answer says of shapes that touch, by points that are kept or not, in A's frame.
struct TouchingPoints {
  bool is_answered = false;  ///< there is an answer
  bool touches = false;
  Vector2<double> normal{0, 0};  ///< from A to B; of points the deepest's
  double depth = 0;              ///< of points the deepest's
  std::vector<ContactPoint<double>>
      points;  ///< of depth 0 or more, the deepest first; if it gives any

  /// The two that are farthest from each other along the tangent, or the only one.
  Manifold<double> ends() const;
};

TouchingPoints touching_points(const Answer& answer);
TouchingPoints touching_points(const PairCase& pair, const KeptAnswer& answer);

/// How the exact clip stands in a frame; undecided where rounding to float may show another.
struct ClipNow {
  bool is_decided = false;
  int count = 0;  ///< of points

  friend bool operator==(const ClipNow&, const ClipNow&) = default;
};

ClipNow clip_now(const Admissible& right);

/// How many of these points linger: the shapes are apart there along the normal by more than
/// `bound`, a length, or not in front of each other at all.
int lingering_points(const PairCase& pair, const TouchingPoints& said, double bound);

}  // namespace manifuzz
