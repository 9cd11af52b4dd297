#pragma once

#include <optional>
#include <span>

#include "exact/curve.hpp"

namespace manifuzz::exact {

// Whether a contact point is one: as seen along the normal, there is a place on A's core that faces
// B and one on B's that faces A, both near the point's line, so that the point lies where it claims
// to lie and they overlap by what it claims. The places need not lie on one line: where corners
// pass each other, which lines meet both depends on rounding alone. A core that is narrow along the
// tangent may face the other with either side: there vertices count, too, and what lies between.
// top is the height of A's place, bottom that of B's, and the gap is top - bottom + R, positive
// where they overlap.

/// Where on its line a point lies: of_top * top + of_bottom * bottom + offset, world lengths.
struct Height {
  double of_top = 0;  ///< with of_bottom: 1 and 0, 0 and 1, or a half of both
  double of_bottom = 0;
  double offset = 0;
};

/// What a point claims, and how far each may be off: world lengths.
struct PointClaim {
  Vector2<double> position{0, 0};   ///< in A's frame
  std::span<const Height> heights;  ///< it lies at one of them
  double gap_least = 0;
  double gap_most = 0;
  double along = 0;   ///< how far either place may be from the point's line
  double across = 0;  ///< how far the point may be from its height
  double slack = 0;   ///< of the gap
  double narrow = 0;  ///< how wide a core is that rounding may turn over
  /// Where the point stands for the deepest overlap: by how much the gap may fall short of D(n).
  std::optional<double> shortfall{};
};

/// Exact: whether there are such places.
bool is_witness(const Truth& truth, const Along& along, const PointClaim& claim);

/// Exact: whether a point of A's frame is within a world length of a vertex of either core.
bool is_at_vertex(const Truth& truth, const Vector2<double>& position, double bound);

}  // namespace manifuzz::exact
