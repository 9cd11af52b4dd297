#pragma once

#include <BulletCollision/CollisionDispatch/btConvexConvexAlgorithm.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <vector>

#include "oracle/bullet/algorithm.hpp"

namespace manifuzz_bullet {

/// The points of btConvexConvexAlgorithm that turns the smaller shape three times where it has
/// fewer than four, in a new manifold.
inline std::vector<btManifoldPoint> perturbed_points(const CollisionObjects& objects) {
  constexpr int turns = 3;
  constexpr int enough_points = 4;
  btGjkEpaPenetrationDepthSolver solver;
  return points_of(objects, [&](const auto& info, const auto& of_a, const auto& of_b) {
    return btConvexConvexAlgorithm(nullptr, info, &of_a, &of_b, &solver, turns, enough_points);
  });
}

}  // namespace manifuzz_bullet
