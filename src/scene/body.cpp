#include "scene/body.hpp"

#include <array>

namespace manifuzz::scene {

std::optional<Defect> find_defect(const Pose<float>& pose) {
  const Vector2<float>& p = pose.position;
  if (!std::isfinite(p.x()) || !std::isfinite(p.y())) return Defect::position_not_finite;
  if (std::abs(p.x()) > kLengthMax || std::abs(p.y()) > kLengthMax) return Defect::position_too_far;
  if (!is_unit_rotation(pose.rotation)) return Defect::rotation_not_unit;
  return std::nullopt;
}

std::string_view describe(Defect defect) {
  constexpr std::array<std::string_view, 8> descriptions{
      "a position is not finite",
      "a position is too far out: coordinates are at most 1e15",
      "a rotation is not unit: cos^2 + sin^2 must be 1 within 1e-5",
      "a shape is too large: its reach and its radius are at most 1e15",
      "a shape is too sharp: its corners are at least 2e-5 wide",
      "a setting is not a length: 0 to 1e15 is expected",
      "no such shape: an index that add_shape gave is expected",
      "no such body: it was removed, or never added"};
  return descriptions[static_cast<std::size_t>(defect)];
}

}  // namespace manifuzz::scene
