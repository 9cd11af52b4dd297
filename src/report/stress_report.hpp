#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "measure/stress/stress.hpp"

namespace manifuzz {

/// Sweep by collider: breaking points; then the walks. For people.
std::string stress_table(const StressPlan& plan, const StressResult& result);

/// The arrays "sweeps" and "walks".
nlohmann::ordered_json stress_sweeps_json(const StressPlan& plan, const StressResult& result);
nlohmann::ordered_json stress_walks_json(const StressPlan& plan, const StressResult& result);

/// Every step with commas, then the walks, a heading first; columns that are not for a row are
/// empty.
std::string stress_csv(const StressPlan& plan, const StressResult& result);

}  // namespace manifuzz
