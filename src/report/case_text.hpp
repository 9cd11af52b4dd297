#pragma once

#include <string>

#include "report/shown_case.hpp"

namespace manifuzz {

/// The case for a terminal: verdict, polygons, truth, bounds, candidate and answers. Numbers read
/// back bit for bit.
std::string case_text(const ShownCase& shown);

}  // namespace manifuzz
