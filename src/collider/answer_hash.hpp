#pragma once

#include <bit>
#include <cstdint>

#include "base/random.hpp"
#include "collider/collider.hpp"

// Every bit of answers, as one number: equal numbers, equal bits.

namespace manifuzz {

/// Words one after the other: each step is one to one, so another word gives another value.
class Hash {
 public:
  void add(std::uint64_t word) { value_ = mix(value_ ^ word); }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add(const Vector2<double>& v) {
    add(v.x());
    add(v.y());
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = hash_of("digest");
};

inline std::uint64_t word_of(const Feature& feature) {
  return std::uint64_t{feature.index} << 8 | static_cast<std::uint64_t>(feature.kind);
}

inline void add(Hash& hash, const Manifold<double>& manifold) {
  hash.add(static_cast<std::uint64_t>(manifold.count));
  if (manifold.count == 0) return;
  hash.add(manifold.normal);
  hash.add(static_cast<std::uint64_t>(manifold.reference));
  for (int i = 0; i < manifold.count; ++i) {
    const ContactPoint<double>& point = manifold.points[i];
    hash.add(point.position);
    hash.add(point.depth);
    hash.add(word_of(point.features.a) << 16 | word_of(point.features.b));
  }
}

/// What a collider said, in double, wherever it runs and whatever ran it.
inline void add(Hash& hash, const Answer& answer) {
  hash.add(static_cast<std::uint64_t>(answer.index()));
  if (const auto* const penetration = std::get_if<Penetration>(&answer)) {
    hash.add(std::uint64_t{penetration->touches});
    hash.add(penetration->normal.value_or(Vector2<double>(0, 0)));
    hash.add(penetration->depth);
  }
  if (const auto* const manifold = manifold_in(answer)) add(hash, *manifold);
  if (const UsedShapes* const used = used_by(answer)) {
    for (const Side side : {Side::a, Side::b}) {
      hash.add(static_cast<std::uint64_t>((*used)[side].count));
      for (const Vector2<double>& vertex : (*used)[side].corners()) hash.add(vertex);
      if (const auto radius = (*used)[side].round_radius) hash.add(static_cast<double>(*radius));
    }
  }
  if (const auto* const lost = std::get_if<Lost>(&answer)) {
    hash.add(static_cast<std::uint64_t>(lost->how));
  }
}

}  // namespace manifuzz
