#pragma once

#include <vector>

#include "canary/acting.hpp"
#include "unit/sequence/keepers.hpp"

namespace manifuzz::canary {

/// Registers for each bug planted into the judge of sequences the test that it is caught. To be
/// called before main.
bool add_sequence_judges(const std::vector<Bug>& bugs, test::JudgeOfSequence judge);

}  // namespace manifuzz::canary
