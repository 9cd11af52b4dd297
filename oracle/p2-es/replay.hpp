#pragma once

#include <optional>

#include "geometry/pair_case.hpp"

namespace manifuzz::ledger_of {

// p2's circleCircle, circleLine and circleConvex, as the adapter calls them: the operations are
// p2's in their order, vectors rounded to float where it stores them, so that but for V8's cosine
// and sine the numbers are the engine's.

/// What p2 finds of a circle and another shape.
struct ContactOfP2 {
  /// By which of its branches.
  enum class Branch { circles, beside_line, first_end, second_end, face, vertex };
  Branch branch = Branch::circles;  ///< which of them
  Vector2<double> normal{0, 0};     ///< from A to B, in the world
  double depth = 0;                 ///< a world length, 0 or more
  Vector2<double> at{0, 0};         ///< on the other shape, or the second circle; in the world
};

/// Whether a capsule's direction is that of its ends, which are rounded, or of its angle; with that
/// the nearest of its ends is taken, not the first within reach.
enum class EdgeOfP2 { of_ends, of_angle };

/// Nothing where it finds no contact, or neither shape is a circle.
std::optional<ContactOfP2> circle_contact_of_p2(const PairCase& pair,
                                                EdgeOfP2 edge = EdgeOfP2::of_ends);

}  // namespace manifuzz::ledger_of
