#pragma once

#include <functional>
#include <string>

#include "campaign/known.hpp"
#include "campaign/replay.hpp"
#include "collider/collider.hpp"
#include "process/interruption.hpp"
#include "properties/properties.hpp"

namespace manifuzz {

// What becomes of a case that a property fails on, however it was found.

/// The collider, which declines whatever there is no time for: from then on a property holds of all
/// that is left, shrinking included.
Collider until(const std::function<bool()>& is_over, const Collider& collider);

/// The property on one case, asked in a child process: a collider that dies or hangs fails it.
/// Throws Interrupted.
PropertyOutcome check_in_child(const Property& property, const Collider& collider,
                               const PairCase& pair, Interruption& interruption);

/// Whether an outcome is a failure for the root's reason, and about as great.
bool fails_alike(const PropertyOutcome& outcome, const PropertyOutcome& root);

/// The smallest case that fails as this one, whose outcome is `root`. Ends early, with the smallest
/// so far, at the first signal from now on. Throws Interrupted where it had not begun.
PairCase shrink_failure(const Property& property, const Collider& collider, const PairCase& pair,
                        const PropertyOutcome& root, Interruption& interruption);

/// Says of a property that fails what the corpus accepts of it, and saves its case in the folder
/// `save_to`, unless that is empty or it is accepted.
void settle_failure(CheckedProperty& checked, const Collider& subject, const Known& known,
                    const std::string& save_to);

}  // namespace manifuzz
