#pragma once

#include <optional>

#include "collider/sequence_collider.hpp"

namespace manifuzz {

/// Bullet's btPersistentManifold, filled by its btConvexConvexAlgorithm with
/// btGjkEpaPenetrationDepthSolver and no perturbations, over frames; nothing where Bullet is not
/// installed. It runs in this process.
std::optional<SequenceCollider> make_bullet_cached();

}  // namespace manifuzz
