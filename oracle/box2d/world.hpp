#pragma once

#include <span>
#include <vector>

#include "geometry/pair_case.hpp"

namespace manifuzz {

/// A body of a world to be simulated.
struct WorldBody {
  Body body;
  bool is_fixed = false;
};

/// The poses of all bodies after each step of `b2World::Step` (b2_world.cpp): 1/60 s, 8 and 3
/// iterations, gravity 10 downwards, density 1, friction 0.5, sleep allowed. Lengths are metres;
/// polygons are taken as they stand, skins and all.
std::vector<std::vector<Pose<float>>> box2d_trajectory(std::span<const WorldBody> bodies,
                                                       int steps);

}  // namespace manifuzz
