#pragma once

#include <string>

#include "measure/stress/breaking_points.hpp"

namespace manifuzz {

/// Sweep by collider: breaking points; then the walks. For people.
std::string stress_table(const StressPlan& plan, const StressResult& result);

/// How far a run is, and how long it takes from there.
std::string progress_line(const StressProgress& progress);

/// What decides the status, in words: nothing where no breaking point is worse than stored and
/// every one was compared.
std::string complaints(const Comparison& comparison);

}  // namespace manifuzz
