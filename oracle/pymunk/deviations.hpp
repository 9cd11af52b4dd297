#pragma once

#include "judging/ledger.hpp"

namespace manifuzz {

// What the ledger's entries on Munk2D look for beside Chipmunk's own faults.

/// Munk2D: a normal without length. Boxes around both shapes have one middle, so that GJK begins
/// with one support point twice.
bool zero_normal_of_one_middle(const Deviation& deviation);

}  // namespace manifuzz
