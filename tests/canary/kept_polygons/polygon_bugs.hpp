#pragma once

#include <vector>

#include "canary/acting.hpp"
#include "collider/sequence_collider.hpp"

namespace manifuzz::canary {

/// Registers for each bug planted into a keeper of polygons the test that the judge of sequences
/// finds it. To be called before main.
bool add_polygon_keepers(const std::vector<Bug>& bugs, SequenceCollider (*make)());

}  // namespace manifuzz::canary
