#pragma once

#include "collider/collider.hpp"

namespace manifuzz::box2d {

/// What Box2D makes of a pair with a circle or an edge: `b2CollideCircles`,
/// `b2CollidePolygonAndCircle` (b2_collide_circle.cpp), `b2CollideEdgeAndCircle` and
/// `b2CollideEdgeAndPolygon` (b2_collide_edge.cpp), the edge with its radius. It has no edge
/// against edge, and no polygon with round corners but against circles.
Answer collide_round(const PairCase& pair);

/// Whether it takes a round pair.
bool takes_round(const PairCase& pair);

}  // namespace manifuzz::box2d
