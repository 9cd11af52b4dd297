#pragma once

#include <cstdint>

namespace manifuzz::scene {

/// Says which bodies may touch, by Box2D's rule (b2ContactFilter::ShouldCollide): two of one group
/// that is not 0 do where it is above 0, and do not where it is below. All others do where the
/// category of each is in the other's mask.
struct Filter {
  std::uint32_t category = 1;              ///< bits: what the body is
  std::uint32_t mask = ~std::uint32_t{0};  ///< bits: categories that it touches
  std::int32_t group = 0;                  ///< 0: none

  friend bool operator==(const Filter&, const Filter&) = default;
};

/// What a body is to others. The default touches all, and is touched.
struct Rules {
  Filter filter{};         ///< which bodies it may touch
  bool is_static = false;  ///< it touches no other static body; it may be moved all the same
  bool is_sensor = false;  ///< its contacts say that it touches, and have no points

  friend bool operator==(const Rules&, const Rules&) = default;
};

/// Whether the filters let two bodies touch.
inline bool may_touch(const Filter& p, const Filter& q) {
  if (p.group == q.group && p.group != 0) return p.group > 0;
  return (p.mask & q.category) != 0 && (q.mask & p.category) != 0;
}

/// Whether two bodies may touch by all that their rules say.
inline bool may_touch(const Rules& p, const Rules& q) {
  return !(p.is_static && q.is_static) && may_touch(p.filter, q.filter);
}

}  // namespace manifuzz::scene
