#pragma once

#include "measure/scene/trajectory.hpp"

// Scenes recorded from Box2D's own world; larger ones are recordings side by side.

namespace manifuzz {

/// Polygons that fall onto each other between walls.
Trajectory make_pile(std::size_t bodies, int steps);

/// A pile that has come to rest; in each step a tenth of it, in turn, is nudged or falls back.
Trajectory make_resting_pile(std::size_t bodies, int steps);

/// Boxes in pyramids that settle.
Trajectory make_pyramid(std::size_t bodies, int steps);

/// Polygons that fall far from each other, and lie where they fell.
Trajectory make_rain(std::size_t bodies, int steps);

}  // namespace manifuzz
