#pragma once

#include "measure/scene/trajectory.hpp"

// Scenes whose motion is written down, not simulated. The same on every machine.

namespace manifuzz {

/// Polygons of 3 to 8 vertices, about one across, with Box2D's skin.
std::vector<ConvexPolygon<float>> mixed_shapes();

/// Far from each other, each on its way and turning.
Trajectory make_sparse_drift(std::size_t bodies, int steps);

/// Boxes in a grid, each turning on the spot, corner against corner.
Trajectory make_spinning_grid(std::size_t bodies, int steps);

/// One body on its way through a field that rests.
Trajectory make_one_mover(std::size_t bodies, int steps);

/// Needles, all moving, in a crowd.
Trajectory make_slivers(std::size_t bodies, int steps);

/// A field in which all touch and nothing moves.
Trajectory make_still(std::size_t bodies, int steps);

}  // namespace manifuzz
