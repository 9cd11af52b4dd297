#pragma once

#include "collider/collider.hpp"
#include "corpus/shrink.hpp"
#include "process/interruption.hpp"

namespace manifuzz {

/// A shrunk case keeps at least this share of the magnitude.
inline constexpr double kMagnitudeShareKept = 0.5;

/// The smallest case like this one: same bucket, same ledger entry, enough of the magnitude. Runs
/// in a child process, so that a collider may die; ends early, with the smallest so far, at the
/// first signal from now on. Throws Interrupted where it had not begun.
Shrunk shrink_finding(const PairCase& pair, const Collider& subject, const Collider& oracle,
                      Interruption& interruption);

}  // namespace manifuzz
