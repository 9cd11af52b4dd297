#pragma once

#include <functional>
#include <span>

#include "geometry/pair_case.hpp"

namespace manifuzz {

// One query of Bullet's btGjkPairDetector through all pairs once, the prisms made before; empty
// where Bullet is not installed.

/// With btGjkEpaPenetrationDepthSolver.
std::function<void()> bullet_epa_pass(std::span<const PairCase> pairs);
/// With btMinkowskiPenetrationDepthSolver.
std::function<void()> bullet_minkowski_pass(std::span<const PairCase> pairs);

}  // namespace manifuzz
