#pragma once

#include <functional>
#include <span>

#include "geometry/pair_case.hpp"

namespace manifuzz {

// One query of Bullet's through all pairs once, the prisms made before.

/// btGjkPairDetector with btGjkEpaPenetrationDepthSolver.
std::function<void()> bullet_epa_pass(std::span<const PairCase> pairs);
/// btGjkPairDetector with btMinkowskiPenetrationDepthSolver.
std::function<void()> bullet_minkowski_pass(std::span<const PairCase> pairs);
/// btConvexConvexAlgorithm, perturbed three times.
std::function<void()> bullet_perturbed_pass(std::span<const PairCase> pairs);

}  // namespace manifuzz
