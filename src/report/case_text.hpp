#pragma once

#include <string>

#include "campaign/judged_case.hpp"

namespace manifuzz {

/// The case for a terminal: verdict, polygons, truth, bounds, candidate and answers. Numbers read
/// back bit for bit.
std::string case_text(const JudgedCase& judged);

}  // namespace manifuzz
