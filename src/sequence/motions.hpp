#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "base/random.hpp"
#include "geometry/sequence.hpp"

namespace manifuzz {

/// A family of sequences: what a regime is to pair cases.
struct Motion {
  std::string_view name;
  std::string_view description;  ///< one line for `list motions`
  Sequence (*draw)(Random& random);
};

/// Every motion, in the order of `list motions`.
std::span<const Motion> motions();

/// Sequence `index` of a motion: a function of (seed, the motion's name, index).
Sequence draw_sequence(std::uint64_t seed, const Motion& motion, std::uint64_t index);

}  // namespace manifuzz
