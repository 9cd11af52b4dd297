#pragma once

#include <bit>
#include <cstdint>

#include "geometry/manifold.hpp"

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

/// Of manifolds with points.
inline bool same_bits(const Manifold<float>& m, const Manifold<float>& n) {
  if (m.count != n.count || m.reference != n.reference || !same_bits(m.normal, n.normal)) {
    return false;
  }
  for (int i = 0; i < m.count; ++i) {
    const ContactPoint<float>& p = m.points[i];
    const ContactPoint<float>& q = n.points[i];
    if (!same_bits(p.position, q.position) || !same_bits(p.depth, q.depth) ||
        !(p.features == q.features)) {
      return false;
    }
  }
  return true;
}

}  // namespace manifuzz
