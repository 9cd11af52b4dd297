#pragma once

#include "judging/ledger.hpp"

namespace manifuzz {

// What the ledger's entries on cp look for beside Chipmunk's own faults.

/// cp: a normal that is shorter than unit as 1e-15 beside the length that it is divided by makes
/// it, and right else, or wrong in a way of Chipmunk's.
bool normal_short_by_cp(const Deviation& deviation);

}  // namespace manifuzz
