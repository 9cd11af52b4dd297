#pragma once

#include <string>

#include "campaign/judged_case.hpp"

namespace manifuzz {

/// The case as an SVG document: verdict, polygons, overlap, reference and incident, every
/// collider's points with their depths, closer views of what is too small to be seen, a legend.
std::string case_svg(const JudgedCase& judged);

}  // namespace manifuzz
