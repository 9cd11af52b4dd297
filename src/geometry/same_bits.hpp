#pragma once

#include <bit>
#include <cstdint>

#include "geometry/pose.hpp"

namespace manifuzz {

/// Equal to the last bit: 0 and -0 differ, a NaN is what it is.
inline bool same_bits(float x, float y) {
  return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y);
}

inline bool same_bits(const Vector2<float>& v, const Vector2<float>& w) {
  return same_bits(v.x(), w.x()) && same_bits(v.y(), w.y());
}

inline bool same_bits(const Pose<float>& p, const Pose<float>& q) {
  return same_bits(p.position, q.position) && same_bits(p.rotation, q.rotation);
}

}  // namespace manifuzz
