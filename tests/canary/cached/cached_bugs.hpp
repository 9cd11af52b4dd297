#pragma once

#include <vector>

#include "canary/acting.hpp"
#include "collider/sequence_collider.hpp"

namespace manifuzz::canary {

using MakeKeeper = SequenceCollider (*)();

/// Registers for each bug planted into what keeps points the test that the judge of sequences
/// blames one of these for it. To be called before main.
bool add_keepers(const std::vector<Bug>& bugs, const std::vector<MakeKeeper>& makes);

}  // namespace manifuzz::canary
