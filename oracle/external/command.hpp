#pragma once

#include <string>

#include "collider/collider.hpp"

namespace manifuzz {

/// A program's first answer, before which it may have to be compiled, may take so long.
inline constexpr double kStartSecondsMax = 10;

/// A program that answers case lines with manifold lines (corpus/README.md states both), as a
/// collider. One that dies, hangs longer than `seconds_max` over a case (the first one:
/// `start_seconds_max`), or answers what is no manifold, loses that case. Throws UserError where it
/// cannot be started or declares nonsense.
Collider collider_of_command(const std::string& command, double seconds_max,
                             double start_seconds_max = kStartSecondsMax);

}  // namespace manifuzz
