#pragma once

#include <optional>

#include "judging/judge.hpp"

namespace manifuzz::canary {

/// The judgement that blames somebody for an answer to the case; none where all is well.
std::optional<Judgement> blame(const PairCase& pair, const ColliderAnswer& subject,
                               const ColliderAnswer& oracle);
std::optional<Judgement> blame(const PairCase& pair, const Collider& subject,
                               const Collider& oracle);

}  // namespace manifuzz::canary
