#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace manifuzz {

/// The float `steps` away in the order of the floats; x itself where that would not be finite.
inline float stepped(float x, int steps) {
  constexpr std::int64_t sign = 0x80000000;
  const std::int64_t bits = std::bit_cast<std::uint32_t>(x);
  const std::int64_t ordered = (bits < sign ? bits : sign - bits) + steps;
  const std::int64_t moved = ordered >= 0 ? ordered : sign - ordered;
  const float result = std::bit_cast<float>(static_cast<std::uint32_t>(moved));
  return std::isfinite(x) && std::isfinite(result) ? result : x;
}

/// The distance from |x| to the next float above it.
inline double ulp_of(double x) {
  const float magnitude = static_cast<float>(std::abs(x));
  return static_cast<double>(stepped(magnitude, 1)) - static_cast<double>(magnitude);
}

}  // namespace manifuzz
