#include "measure/stress/step_statistics.hpp"

#include <algorithm>

namespace manifuzz {

bool is_broken(const ErrorStatistics& step) {
  if (step.wrong() > 0 && step.wrong() * kWrongEvery >= step.well_posed()) return true;
  const ErrorSpreads& errors = step.of_size;
  return std::max({errors.depth.p999, errors.position.p999, errors.normal.p999}) > kGrossShare;
}

std::optional<std::size_t> breaking_step(std::span<const StepStatistics> steps) {
  const auto broken = std::ranges::find_if(steps, is_broken);
  if (broken == steps.end()) return std::nullopt;
  return static_cast<std::size_t>(broken - steps.begin());
}

}  // namespace manifuzz
