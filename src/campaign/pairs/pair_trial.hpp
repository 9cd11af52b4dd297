#pragma once

#include "campaign/named_colliders.hpp"
#include "campaign/trial.hpp"

namespace manifuzz {

/// Two colliders that are asked about pair cases.
std::shared_ptr<const Trial> trial_of_pairs(const Collider& subject, const Collider& oracle);

/// By the colliders that pair cases name.
TrialOf trials_of_pairs(const std::shared_ptr<NamedColliders>& colliders);

}  // namespace manifuzz
