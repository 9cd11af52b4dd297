#pragma once

#include <optional>

#include "oracle/godot3/shapes.hpp"

namespace manifuzz::as_godot {

/// What Shape2D.collide_and_get_contacts gives, as relay.py takes it: points on A, one depth.
struct GodotAnswer {
  replayed::Contact contact;
  Vector2<double> axis{0, 0};             ///< of the least overlap, from A to B
  double depth = 0;                       ///< along it
  bool is_without_support = false;        ///< get_supports finds none, and sets no count
  std::array<std::vector<int>, 2> edges;  ///< `Shape::edges_met`, of A and of B
};

/// sat_2d_calculate_penetration; where an axis is given, from A to B, as if it had found that.
GodotAnswer by_godot(const PairCase& pair, const Mends& mends,
                     const std::optional<Vector2<double>>& axis = std::nullopt);

}  // namespace manifuzz::as_godot
