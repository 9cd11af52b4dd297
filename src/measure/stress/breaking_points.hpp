#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "measure/stress/stress.hpp"

namespace manifuzz {

/// What is stored of a sweep or a walk and one subject.
struct StoredPoint {
  const Sweep* sweep = nullptr;
  const Walk* walk = nullptr;
  std::size_t subject = 0;
  std::size_t step = 0;      ///< of the sweep, that breaks; the number of its steps: none does
  std::uint64_t faults = 0;  ///< of the walk
};

/// What a file stores of the sweeps, walks and subjects of a plan. Throws UserError where it
/// stores nothing of them, or what no run writes, or what was measured on other terms.
std::vector<StoredPoint> read_breaking_points(const std::string& path, const StressPlan& plan);

struct Comparison {
  /// A line for each breaking point that lies before the stored one, and each walk with more
  /// faults.
  std::vector<std::string> worse;
  /// A line for each sweep and walk that was interrupted before it could be compared.
  std::vector<std::string> not_compared;
};

Comparison compare(const StressPlan& plan, const StressResult& result,
                   const std::vector<StoredPoint>& stored);

/// What is stored in a file, for a run of this plan to be added; nothing where there is no file.
/// Throws UserError where it is none of such, or on other terms.
nlohmann::ordered_json stored_before(const std::string& path, const StressPlan& plan);

/// `before`, and over it what a whole run found of each sweep and collider, where it breaks, and of
/// each walk, its faults; with the terms that must be the same for a fair comparison.
nlohmann::ordered_json breaking_points_json(const StressPlan& plan, const StressResult& result,
                                            nlohmann::ordered_json before);

}  // namespace manifuzz
