#pragma once

#include "collider/sequence_collider.hpp"

namespace manifuzz {

/// Bullet's btPersistentManifold, filled by its btConvexConvexAlgorithm with
/// btGjkEpaPenetrationDepthSolver and no perturbations, over frames. It runs in this process.
SequenceCollider make_bullet_cached();

}  // namespace manifuzz
