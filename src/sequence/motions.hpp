#pragma once

#include <cstdint>
#include <functional>
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

/// A sequence has at least so many frames.
inline constexpr int kMinFrames = 4;
/// A sequence has at most so many frames.
inline constexpr int kMaxFrames = 40;

/// Every motion, in the order of `list motions`.
std::span<const Motion> motions();

/// The motion of that name, or nullptr.
const Motion* find_motion(std::string_view name);

/// The sequences that are asked for; all where it is empty.
using TakesSequence = std::function<bool(const Sequence&)>;

/// Sequence `index` of a motion: a function of (seed, the motion's name, index), the first of many
/// that is taken. Where none is, it is the first.
Sequence draw_sequence(std::uint64_t seed, const Motion& motion, std::uint64_t index,
                       const TakesSequence& takes = {});

/// Whether any sequences of a motion are taken.
bool has_taken(const Motion& motion, const TakesSequence& takes);

}  // namespace manifuzz

namespace manifuzz::motion {

/// The one list of motions: a name, and a line for `list motions`. Each is a function of that name
/// below, defined in motions.cpp. A sequence depends on the name, not on the place.
#define MANIFUZZ_MOTIONS(MOTION)                                                                 \
  MOTION(resting, "one body stands on the other, or settles: it trembles by ulps to 1e-4 sizes") \
  MOTION(rocking, "tilts back and forth, so that contact changes between a face's ends")         \
  MOTION(sliding, "slides along a face, slowly or past 0.02 of the size in a frame")             \
  MOTION(rolling, "a circle, a regular polygon or a rounded one rolls along a face")             \
  MOTION(turning_platform, "both bodies turned together, and carried along a path")              \
  MOTION(apart_and_back, "a gap that opens and closes, past 0.02 of the size")                   \
  MOTION(teleport, "a body jumps away and comes back, to its place or next to it")               \
  MOTION(tiny_bodies, "bodies of 1e-4 to 1e-2 across, with each other or with usual ones")

#define MANIFUZZ_DECLARE(name, description) Sequence name(Random& random);
MANIFUZZ_MOTIONS(MANIFUZZ_DECLARE)
#undef MANIFUZZ_DECLARE

}  // namespace manifuzz::motion
