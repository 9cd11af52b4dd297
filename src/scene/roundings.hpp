#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/pose.hpp"

// The constants of certificates.md, which derives them.

namespace manifuzz::scene {

/// The roundoff of a float.
inline constexpr float kRoundoff = std::numeric_limits<float>::epsilon() / 2;

/// How far a face's separation as the kernel rounds it may be from the same of the exact poses, as
/// a share of the extent: 15 u, and the defect of two rotations.
inline constexpr float kSeparationError = 15 * kRoundoff + 2.1e-5F;

/// More than all that is lost to underflow.
inline constexpr float kUnderflow = 64 * std::numeric_limits<float>::min();

/// At least |v|, at most 8% more; without a square, which could underflow.
inline float length_at_most(const Vector2<float>& v) {
  const float x = std::abs(v.x());
  const float y = std::abs(v.y());
  return std::max(x, y) + 0.41422F * std::min(x, y);
}

/// More than the roundings of a displacement, and than what the extent grows by meanwhile.
inline constexpr float kRoundUp = 1.001F;

/// Less than the roundings of a difference of two floats add.
inline constexpr float kRoundDown = 0.999F;

/// At least how far any vertex of a polygon of this reach (a length) has moved from one pose to
/// another, both in one frame; a length.
inline float displacement(const Pose<float>& from, const Pose<float>& to, float reach) {
  return kRoundUp * (length_at_most(to.position - from.position) +
                     reach * length_at_most(to.rotation - from.rotation));
}

}  // namespace manifuzz::scene
