#pragma once

#include <span>
#include <string>

#include "campaign/plan.hpp"

namespace manifuzz {

/// A collider that keeps points, as campaigns and replays count it: it declares itself, and cannot
/// be asked.
Collider as_declared(const SequenceCollider& subject);

/// Who is right about a sequence: of no name, where colliders are listed.
Collider no_oracle();

/// Makes it a campaign of sequences of these motions; for no name of all that have shapes which the
/// subject takes. Throws UserError where there is no such motion.
void plan_sequences(Plan& plan, const SequenceCollider& subject,
                    std::span<const std::string> names);

}  // namespace manifuzz
