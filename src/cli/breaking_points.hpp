#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "measure/stress.hpp"

namespace manifuzz {

/// What a run found of each sweep and collider: where it breaks; and of each walk: its faults, with
/// the terms that must be the same for a fair comparison.
nlohmann::ordered_json breaking_points_json(const StressPlan& plan, const StressResult& result);

/// Breaking points that were stored. Throws UserError where the file is none of such, or was
/// measured on other terms than the plan's.
nlohmann::ordered_json read_breaking_points(const std::string& path, const StressPlan& plan);

/// A line for each breaking point of the run that lies before the stored one, and for each walk
/// with more faults.
std::vector<std::string> moved_down(const StressPlan& plan, const StressResult& result,
                                    const nlohmann::ordered_json& stored);

}  // namespace manifuzz
