#pragma once

#include "judging/admissible.hpp"
#include "judging/bucket.hpp"

namespace manifuzz {

/// The tie of what is right for two colliders: the first decision that lies within the wider of
/// both bounds.
TieClass tie_class(const Admissible& subject, const Admissible& oracle);

}  // namespace manifuzz
