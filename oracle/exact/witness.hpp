#pragma once

#include <optional>
#include <span>

#include "oracle/exact/curve.hpp"

namespace manifuzz::exact {

// Whether a contact point is one: some line along the normal, near it, that meets both cores, on
// which it lies where it claims to lie and overlaps by what it claims. top is the highest point of
// A's core on that line, bottom the lowest of B's, as seen along the normal; the gap is top -
// bottom + R, positive where they overlap.

/// Where on its line a point lies: of_top * top + of_bottom * bottom + offset, world lengths.
struct Height {
  double of_top = 0;
  double of_bottom = 0;
  double offset = 0;
};

/// What a point claims, and how far each may be off: world lengths.
struct PointClaim {
  Vector2<double> position{0, 0};   ///< in A's frame
  std::span<const Height> heights;  ///< it lies at one of them
  double gap_least = 0;
  double gap_most = 0;
  double along = 0;   ///< how far the line may be from the point
  double across = 0;  ///< how far the point may be from its height
  double slack = 0;   ///< of the gap
  /// Where the point stands for the deepest overlap: by how much the gap may fall short of D(n).
  std::optional<double> shortfall{};
};

/// Exact: whether there is such a line.
bool is_witness(const Truth& truth, const Along& along, const PointClaim& claim);

}  // namespace manifuzz::exact
