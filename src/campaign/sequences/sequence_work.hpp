#pragma once

#include <span>
#include <string>

#include "campaign/plan.hpp"
#include "collider/sequence_collider.hpp"

namespace manifuzz {

/// Makes it a campaign of sequences of these motions; for no name of all that have shapes which the
/// subject takes. Subject and oracle then only declare themselves, the oracle as the judge, and the
/// regimes only have the motions' names. Throws UserError where there is no such motion.
void plan_sequences(Plan& plan, const SequenceCollider& subject,
                    std::span<const std::string> names);

}  // namespace manifuzz
