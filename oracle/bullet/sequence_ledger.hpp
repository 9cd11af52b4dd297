#pragma once

#include "sequence/sequence_ledger.hpp"

namespace manifuzz {

/// The known deviations of bullet-cached.
SequenceRows bullet_sequence_ledger();

}  // namespace manifuzz
