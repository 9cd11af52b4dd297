#pragma once

#include <string>

#include "report/shown_case.hpp"

namespace manifuzz {

/// The case as an SVG document: verdict, polygons, overlap, reference and incident, every
/// collider's points with their depths, closer views of what is too small to be seen, a legend.
std::string case_svg(const ShownCase& shown);

}  // namespace manifuzz
