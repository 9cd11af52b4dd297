#pragma once

#include "report/departure/steps.hpp"

namespace manifuzz {

/// How else the depths may be told.
void try_depths(const RightWay& way, const TryChoices& attempt);

}  // namespace manifuzz
