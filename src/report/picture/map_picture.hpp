#pragma once

#include <string>

#include "judging/neighbourhood.hpp"
#include "report/judged_case.hpp"

namespace manifuzz {

/// The neighbourhood as a PNG file: what the subject says, what the oracle says, what is true and
/// what that comes to, side by side, with the severity and a legend in words.
std::string map_png(const JudgedCase& shown, const Neighbourhood& neighbourhood);

}  // namespace manifuzz
