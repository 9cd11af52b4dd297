#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "measure/stress/breaking_points.hpp"

namespace manifuzz {

/// Where it was measured, the plan's terms, the comparison, and the arrays "sweeps" and "walks".
nlohmann::ordered_json stress_json(const StressPlan& plan, const StressResult& result,
                                   const Comparison& comparison);

/// Every step with commas, then the walks, a heading first; columns that are not for a row are
/// empty.
std::string stress_csv(const StressPlan& plan, const StressResult& result);

}  // namespace manifuzz
