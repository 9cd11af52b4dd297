#pragma once

#include <string>

#include "campaign/judged_case.hpp"

namespace manifuzz {

/// The case as a report to the authors of the collider at fault, in Markdown: version, input, what
/// it answered, what is right, and a program that shows it. `options` choose the two colliders
/// again, for one that gives no program of its own. Throws UserError where nobody is at fault.
std::string upstream_report(const JudgedCase& judged, const std::string& options);

/// A snippet's template with the pair's numbers in it: @a.vertices[]@ becomes [[x,y],...],
/// @a.vertices{}@ {{x,y},...}; normals, position and rotation (cos, sin) alike; @a.radius@,
/// @a.count@; b as a.
std::string filled_in(std::string snippet, const PairCase& pair);

}  // namespace manifuzz
