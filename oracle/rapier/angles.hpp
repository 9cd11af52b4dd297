#pragma once

#include <cmath>

namespace manifuzz::parry {

// sinf and cosf of Rust's crate libm (musl's), which rapier2d-compat calls: their last bit is not
// always the correctly rounded one. Of floats
// within 9/4 pi, as doubles.

/// k_sinf.
inline double sine_within_eighth(double x) {
  const double z = x * x;
  const double s = z * x;
  const double r = -0x1a00f9e2cae774.0p-65 + z * 0x16cd878c3b46a7.0p-71;
  return (x + s * (-0x15555554cbac77.0p-55 + z * 0x111110896efbb2.0p-59)) + s * (z * z) * r;
}

/// k_cosf.
inline double cosine_within_eighth(double x) {
  const double z = x * x;
  const double w = z * z;
  const double r = -0x16c087e80f1e27.0p-62 + z * 0x199342e0ee5069.0p-68;
  return ((1.0 + z * -0x1ffffffd0c5e81.0p-54) + w * 0x155553e1053a42.0p-57) + (w * z) * r;
}

/// An angle's size as quarter turns and what is left of it, at most an eighth to either side.
struct QuarterTurns {
  int count = 0;
  double rest = 0;

  explicit QuarterTurns(double size) {
    constexpr double kQuarter = 0x1.921fb54442d18p+0;
    while (size > (count + 0.5) * kQuarter) ++count;
    rest = size - count * kQuarter;
  }
};

/// sinf.
inline float sine_of_wasm(double x) {
  const double size = std::abs(x);
  if (size < 0x1p-12) return static_cast<float>(x);
  const QuarterTurns turns(size);
  const double part =
      turns.count % 2 == 0 ? sine_within_eighth(turns.rest) : cosine_within_eighth(turns.rest);
  const bool is_negative = (turns.count % 4 > 1) != (x < 0);
  return static_cast<float>(is_negative ? -part : part);
}

/// cosf.
inline float cosine_of_wasm(double x) {
  const double size = std::abs(x);
  if (size < 0x1p-12) return 1;
  const QuarterTurns turns(size);
  const double part =
      turns.count % 2 == 0 ? cosine_within_eighth(turns.rest) : sine_within_eighth(turns.rest);
  const bool is_negative = (turns.count + 1) % 4 > 1;
  return static_cast<float>(is_negative ? -part : part);
}

}  // namespace manifuzz::parry
