#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

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
  setting_not_a_length,  ///< below 0, above kLengthMax, or not a number
  unknown_shape,         ///< no shape of that index was added
  unknown_body,          ///< no such body is in the scene, or not any more
};

/// The first defect of a pose, or none.
std::optional<Defect> find_defect(const Pose<float>& pose);

/// One clause for a person: what is wrong, and what would be right.
std::string_view describe(Defect defect);

}  // namespace manifuzz::scene
