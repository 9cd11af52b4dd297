#pragma once

#include <optional>
#include <vector>

#include "geometry/pair_case.hpp"

namespace manifuzz::ledger_of {

// b2CollideCapsules and b2CollidePolygons of Box2D 3.2, as the adapter calls them: the operations
// are the engine's in their order, in floats.

/// What it finds of two shapes with edges.
struct ContactOfBox2d3 {
  Vector2<double> normal{0, 0};  ///< from A to B, in the world
  /// A point halfway between both surfaces, in the world.
  struct Point {
    Vector2<double> at;  ///< its place
    double depth = 0;    ///< 0 or more
  };
  std::vector<Point> points{};   ///< those that are no gaps
  bool is_of_capsules = false;   ///< b2CollideCapsules found it
  bool is_clipped = false;       ///< along an edge's normal, not one point between nearest places
  bool is_disjoint = false;      ///< both edges miss each other along the reference face
  bool is_unclipped = false;     ///< the incident edge is too short to be clipped, and sticks out
  bool are_apart = false;        ///< a face is farther than 0.0005
  bool is_beyond_range = false;  ///< of capsules: a product of their cores' squared lengths is
};

/// Nothing of a circle.
std::optional<ContactOfBox2d3> contact_of_box2d3(const PairCase& pair);

}  // namespace manifuzz::ledger_of
