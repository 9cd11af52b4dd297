#pragma once

#include <string>

#include "campaign/run.hpp"

namespace manifuzz {

/// For people: regimes, verdicts (zeros too), findings with their commands.
std::string summary_table(const Campaign& campaign);

/// What of that decides the status, alone; nothing where all is well.
std::string objections(const Campaign& campaign);

/// One line of a running campaign: cases, rate, verdicts that count, time left.
std::string progress_line(const Plan& plan, const Progress& progress);

}  // namespace manifuzz
