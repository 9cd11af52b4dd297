#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "geometry/pair_case.hpp"

namespace manifuzz {

/// 1 to kMaxVertices vertices in a polygon's own frame, and what is around them.
struct UsedVertices {
  std::array<Vector2<double>, kMaxVertices> all;
  int count = 0;
  /// With round corners of this radius, a length; else the case's own radius and rounding.
  std::optional<float> round_radius{};

  std::span<const Vector2<double>> corners() const {
    return {all.data(), static_cast<std::size_t>(count)};
  }
  friend bool operator==(const UsedVertices& p, const UsedVertices& q) {
    return p.round_radius == q.round_radius && std::ranges::equal(p.corners(), q.corners());
  }
};

/// Both polygons of a pair, as an engine has them that makes them its own: it may drop vertices, or
/// move them.
struct UsedShapes {
  UsedVertices a;
  UsedVertices b;

  const UsedVertices& operator[](Side side) const { return side == Side::a ? a : b; }
  UsedVertices& operator[](Side side) { return side == Side::a ? a : b; }
  friend bool operator==(const UsedShapes&, const UsedShapes&) = default;
};

}  // namespace manifuzz
