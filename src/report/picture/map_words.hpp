#pragma once

#include <string>

#include "campaign/judged_case.hpp"
#include "judging/neighbourhood.hpp"

namespace manifuzz {

/// "A clips, 2 points: f1/v0 and v2/f3": features are A's / B's.
std::string statement_in_words(const ContactSummary& statement);

/// What the map is a map of: "vertex 0 of B moved by up to 64 steps of 1 ulp (6e-08) each way ...".
std::string grid_in_words(const Grid& grid);

/// "severity 0.511: box2d is wrong on 8504 of 16641 neighbours", and what was not judged.
std::string severity_in_words(const JudgedCase& judged, const Neighbourhood& neighbourhood);

}  // namespace manifuzz
