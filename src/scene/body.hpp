#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/manifold.hpp"
#include "geometry/pose.hpp"

namespace manifuzz::scene {

/// A body of a scene, for as long as it is in it: what is added in its place later has another
/// generation. (A place comes round to a generation again after 2^31 removals.)
struct BodyHandle {
  std::uint32_t index = 0;       ///< of its place in the scene
  std::uint32_t generation = 0;  ///< odd; 0 names no body

  friend bool operator==(const BodyHandle&, const BodyHandle&) = default;
};

/// No body, no pair, no end of a list.
inline constexpr std::uint32_t kNone = ~std::uint32_t{0};

/// Where a body stands from this step on, in the world.
struct Move {
  BodyHandle body;   ///< which one
  Pose<float> pose;  ///< in the world
};

/// No coordinate of a position and no reach or radius of a shape is larger: products of two stay
/// finite as floats.
inline constexpr float kLengthMax = 1e15F;

/// What can be wrong with what a scene is given.
enum class Defect {
  position_not_finite,   ///< infinite, or not a number
  position_too_far,      ///< a coordinate above kLengthMax
  rotation_not_unit,     ///< |cos^2 + sin^2 - 1| above kRotationTolerance
  shape_too_large,       ///< a reach or radius above kLengthMax
  shape_too_sharp,       ///< a corner is less than 2e-5 radians wide
  shape_is_round,        ///< a point, a segment, or a polygon with round corners
  setting_not_a_length,  ///< below 0, above kLengthMax, or not a number
  unknown_shape,         ///< no shape of that index was added
  unknown_body,          ///< no such body is in the scene, or not any more
};

/// Of a pose that has one.
Defect defect_of(const Pose<float>& pose);

/// The first defect of a pose, or none.
inline std::optional<Defect> find_defect(const Pose<float>& pose) {
  const bool is_near =
      std::abs(pose.position.x()) <= kLengthMax && std::abs(pose.position.y()) <= kLengthMax;
  if (is_near && is_unit_rotation(pose.rotation)) return std::nullopt;
  return defect_of(pose);
}

/// One clause for a person: what is wrong, and what would be right.
std::string_view describe(Defect defect);

/// Two bodies that touch, in a cache line. A is the one of lower index.
struct alignas(64) Contact {
  BodyHandle a;              ///< the manifold is in its frame
  BodyHandle b;              ///< the normal points to it
  Manifold<float> manifold;  ///< of 1 or 2 points, in A's frame
};

/// Two bodies that touch no longer; one of them may be gone.
struct EndedContact {
  BodyHandle a;  ///< the one of lower index
  BodyHandle b;  ///< the other
};

/// What was done with the candidate pairs of a step: counts that add up to `candidates`.
struct PairCounts {
  std::size_t at_rest = 0;     ///< neither body moved: not looked at
  std::size_t separated = 0;   ///< a separating face was proven to separate still
  std::size_t recycled = 0;    ///< touching ones, carried along: 0 in strict mode
  std::size_t collided = 0;    ///< by the kernel
  std::size_t candidates = 0;  ///< pairs that there were when they were looked at
};

/// What the parts of a step did; all are counts.
struct StepCounts {
  PairCounts pairs;               ///< what was done with the candidates
  std::size_t moved = 0;          ///< bodies that moved, were added or got another shape
  std::size_t left_boxes = 0;     ///< of them, those that left their fattened box
  std::size_t pairs_added = 0;    ///< candidates that were none before
  std::size_t pairs_dropped = 0;  ///< candidates that are none any more
  std::size_t proofs = 0;         ///< made of pairs that are apart
};

/// Valid until the scene is next changed.
struct StepResult {
  std::span<const Contact> contacts;     ///< all that touch, in no particular order
  std::span<const std::uint32_t> began;  ///< indices of contacts that did not touch before
  std::span<const EndedContact> ended;   ///< since the last step, removed bodies' too
  std::size_t stayed = 0;                ///< all contacts but those that began
  StepCounts counts;                     ///< what was done, and what was skipped
};

/// Room for so many, in steps that leave little memory unused.
template <class T>
void make_room(std::vector<T>& vector, std::size_t size) {
  if (size > vector.capacity()) vector.reserve(size + size / 8 + 16);
}

/// The same, and that many there.
template <class T>
void resize(std::vector<T>& vector, std::size_t size) {
  make_room(vector, size);
  vector.resize(size);
}

/// Empties a list of what happened to so many bodies; where it once held most of them, and does no
/// more, its memory goes.
template <class T>
void clear_for(std::vector<T>& list, std::size_t bodies) {
  const bool is_large = list.capacity() > bodies / 8 + 64;
  if (is_large && list.size() < list.capacity() / 4) list = std::vector<T>();
  list.clear();
}

}  // namespace manifuzz::scene
