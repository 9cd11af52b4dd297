#pragma once

#include <optional>

#include "judging/faults/replayed.hpp"

namespace manifuzz::ledger_of {

// b2CollidePolygonAndCircle, b2CollideEdgeAndCircle and b2WorldManifold::Initialize of Box2D 2.4.1,
// as the adapter calls them: the operations are the engine's in their order, in floats.

/// What of them is wrong: a bit each, to be mended alone or together.
struct FaultOfBox2dCircle {
  /// A centre in front of a polygon's face by less than b2_epsilon is taken to be behind it.
  static constexpr unsigned face = 1;
  /// b2Vec2::Normalize leaves an edge's normal, or the direction from a polygon's corner, as it is
  /// where that is shorter than b2_epsilon.
  static constexpr unsigned short_direction = 2;
  /// A face is kept, where several tie in floats, that is not the farthest, or that the centre is
  /// not in front of.
  static constexpr unsigned tied_face = 4;
  static constexpr unsigned all = 7;
};

/// What they find of a circle and an edge or a polygon with some faults mended; nothing of any
/// other pair. Without points where they find no contact.
std::optional<replayed::Contact> circle_contact_of_box2d(const PairCase& pair, unsigned mended);

}  // namespace manifuzz::ledger_of
