#pragma once

#include <optional>
#include <span>

#include "measure/error_statistics.hpp"
#include "measure/stress/walk_changes.hpp"

namespace manifuzz {

/// One collider in one step of a sweep, or in a walk: plain data that lies in shared memory.
struct StepStatistics : ErrorStatistics {
  WalkChanges walk;

  friend bool operator==(const StepStatistics&, const StepStatistics&) = default;
};

/// More than one well-posed case in so many wrong breaks a step.
inline constexpr std::uint64_t kWrongEvery = 10'000;

/// Whether a collider has broken: the 99.9th percentile of an error of depth, position or normal
/// exceeds 1% of the size (0.01 of the normal), or one well-posed case in 10^4, rounded up to one
/// case, is wrong.
bool is_broken(const ErrorStatistics& step);

/// The first step that is broken; none where none is.
std::optional<std::size_t> breaking_step(std::span<const StepStatistics> steps);

}  // namespace manifuzz
