#pragma once

#include "measure/scene/trajectory.hpp"
#include "scene/scene.hpp"

namespace manifuzz {

/// What a strict scene's contacts were held against: every pair of bodies, collided afresh.
struct AfreshCheck {
  std::size_t steps = 0;           ///< those that were held against it, spread over the trajectory
  std::size_t mismatches = 0;      ///< contacts that differ by a bit, are missing or too many
  std::vector<PairCase> findings;  ///< the first of them
};

/// As many steps as 60 million pairs allow: all for 1,000 bodies and 100 steps, one for 10,000,
/// none for more.
AfreshCheck check_afresh(const Trajectory& trajectory, const scene::Settings& settings);

}  // namespace manifuzz
