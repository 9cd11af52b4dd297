#include "afresh/defect.hpp"

namespace manifuzz::scene {

Defect defect_of(const Pose<float>& pose) {
  const Vector2<float>& p = pose.position;
  if (!std::isfinite(p.x()) || !std::isfinite(p.y())) return Defect::position_not_finite;
  if (std::abs(p.x()) > kLengthMax || std::abs(p.y()) > kLengthMax) return Defect::position_too_far;
  return Defect::rotation_not_unit;
}

std::string_view describe(Defect defect) {
  switch (defect) {
    case Defect::position_not_finite:
      return "a position is not finite";
    case Defect::position_too_far:
      return "a position is too far out: coordinates are at most 1e15";
    case Defect::rotation_not_unit:
      return "a rotation is not unit: cos^2 + sin^2 must be 1 within 1e-5";
    case Defect::shape_not_convex:
      return "a shape's vertices are none of a shape: 1 with a radius, 2 that differ, or 3 to 8 "
             "strictly convex, counter-clockwise; all finite";
    case Defect::shape_too_large:
      return "a shape is too large: its reach is at most 1e15, its radius from 0 to 1e15";
    case Defect::shape_too_sharp:
      return "a shape is too sharp: corners that are not round are at least 2e-5 wide";
    case Defect::setting_not_a_length:
      return "a setting is not a length: 0 to 1e15 is expected";
    case Defect::unknown_shape:
      return "no such shape: an index that add_shape gave is expected";
    case Defect::unknown_body:
      return "no such body: it was removed, or never added";
    case Defect::unknown_part:
      return "no such part: numbers from 0 to below the count of the body's parts are expected";
    case Defect::no_parts:
      return "a body has no parts: one or more are expected";
  }
  return {};
}

}  // namespace manifuzz::scene
