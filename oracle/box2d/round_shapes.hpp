#pragma once

#include <functional>
#include <span>

#include "collider/collider.hpp"

namespace manifuzz::box2d {

/// What Box2D makes of a pair with a circle or an edge: `b2CollideCircles`,
/// `b2CollidePolygonAndCircle` (b2_collide_circle.cpp), `b2CollideEdgeAndCircle` and
/// `b2CollideEdgeAndPolygon` (b2_collide_edge.cpp), the edge with its radius. It has no edge
/// against edge, and no polygon with round corners but against circles.
Answer collide_round(const PairCase& pair);

/// Whether it takes a round pair.
bool takes_round(const PairCase& pair);

/// Lays round pairs that it takes out as its users hold them, and gives what goes through all of
/// them once.
std::function<void()> round_pass(std::span<const PairCase> pairs);

/// A pass of any pairs that it takes, and `b2WorldManifold` of what touches: of circles Box2D's
/// functions alone give neither a normal nor a depth, of polygons no depths.
std::function<void()> world_pass(std::span<const PairCase> pairs);

}  // namespace manifuzz::box2d
