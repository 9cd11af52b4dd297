#pragma once

#include <span>

#include "sequence/sequence_ledger.hpp"

namespace manifuzz {

/// The known deviations of bullet-cached.
std::span<const SequenceEntry> bullet_sequence_ledger();

}  // namespace manifuzz
