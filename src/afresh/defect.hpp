#pragma once

#include <cmath>
#include <optional>
#include <string_view>

#include "geometry/pose.hpp"

namespace manifuzz::scene {

/// No coordinate of a position and no reach or radius of a shape is larger: products of two stay
/// finite as floats.
inline constexpr float kLengthMax = 1e15F;

/// What can be wrong with what a scene is given.
enum class Defect {
  position_not_finite,   ///< infinite, or not a number
  position_too_far,      ///< a coordinate above kLengthMax
  rotation_not_unit,     ///< |cos^2 + sin^2 - 1| above kRotationTolerance
  shape_not_convex,      ///< its vertices have a `PolygonDefect`
  shape_too_large,       ///< a reach above kLengthMax, or a radius below 0 or above it
  shape_too_sharp,       ///< a corner that is not round is less than 2e-5 radians wide
  setting_not_a_length,  ///< below 0, above kLengthMax, or not a number
  unknown_shape,         ///< no shape of that index was added
  unknown_body,          ///< no such body is in the scene, or not any more
  unknown_part,          ///< the body has no part of that number
  no_parts,              ///< a body of parts was given none
};

/// The defect of a pose that has one.
Defect defect_of(const Pose<float>& pose);

/// Whether a position is finite, and not too far out.
inline bool is_near(const Vector2<float>& position) {
  return std::abs(position.x()) <= kLengthMax && std::abs(position.y()) <= kLengthMax;
}

/// The first defect of a pose, or none.
inline std::optional<Defect> find_defect(const Pose<float>& pose) {
  if (is_near(pose.position) && is_unit_rotation(pose.rotation)) return std::nullopt;
  return defect_of(pose);
}

/// One clause for a person: what is wrong, and what would be right.
std::string_view describe(Defect defect);

}  // namespace manifuzz::scene
