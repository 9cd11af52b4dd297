#pragma once

#include <string>

#include "campaign/judged_case.hpp"
#include "judging/neighbourhood.hpp"

namespace manifuzz {

/// The neighbourhood as a PNG file: what the subject says, what the oracle says, what is true and
/// the verdict, side by side, with the severity and a legend in words.
std::string map_png(const JudgedCase& judged, const Neighbourhood& neighbourhood);

}  // namespace manifuzz
