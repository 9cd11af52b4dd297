#include "campaign/least_cases.hpp"

#include <algorithm>

namespace manifuzz {

void LeastCases::add(std::uint64_t number) {
  if (count_ == kRoom && number >= numbers_.back()) return;
  auto* const end = numbers_.begin() + count_;
  auto* const place = std::lower_bound(numbers_.begin(), end, number);
  if (place != end && *place == number) return;
  if (count_ < kRoom) ++count_;
  std::copy_backward(place, numbers_.begin() + count_ - 1, numbers_.begin() + count_);
  *place = number;
}

void LeastCases::add(const LeastCases& others) {
  for (const std::uint64_t number : others.all()) add(number);
}

}  // namespace manifuzz
