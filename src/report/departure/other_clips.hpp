#pragma once

#include "report/departure/steps.hpp"

namespace manifuzz {

// Steps of the article with one of their choices replaced.

/// What else the clips at the side planes of the reference edge, and the one behind it, may do.
void try_first_clips(const RightWay& way, const TryChoices& attempt);
void try_second_clips(const RightWay& way, const TryChoices& attempt);
void try_third_clips(const RightWay& way, const TryChoices& attempt);

}  // namespace manifuzz
