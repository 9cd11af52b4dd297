#include "afresh/shape_table.hpp"

namespace manifuzz::scene {
namespace {

/// More than rounding to float takes off.
constexpr double kUpward = 1 + 0x1p-22;

/// At corners sharper than this the padding of boxes would grow without bound.
constexpr double kSharpnessMin = 1e-5;

/// No more than the sine of half the angle at a corner: half the angle's own sine where that is
/// acute, or the half of a right angle's.
double half_angle_sine(const ConvexPolygon<float>& polygon, int corner) {
  const auto edge = [&](int i) {
    const Vector2<double> along =
        polygon.vertices[polygon.next(i)].cast<double>() - polygon.vertices[i].cast<double>();
    return Vector2<double>(along / along.cwiseAbs().maxCoeff());
  };
  const Vector2<double> before = edge(polygon.previous(corner));
  const Vector2<double> after = edge(corner);
  if (before.dot(after) >= 0) return 0.7;
  return cross<double>(before, after) / (2 * std::sqrt(before.dot(before) * after.dot(after)));
}

/// `rounded_by` is the radius and the tie bias.
float padding(float reach, float rounded_by, double sharpness) {
  const float share =
      13 * kSeparationError + static_cast<float>(40 * static_cast<double>(kRoundoff) / sharpness);
  return 1.4143F * rounded_by + share * (reach + rounded_by) + kUnderflow;
}

}  // namespace

std::variant<std::uint32_t, Defect> ShapeTable::add(const ConvexPolygon<float>& polygon) {
  if (polygon.is_round()) return Defect::shape_is_round;
  const bool has_vertices = polygon.count >= kMinVertices && polygon.count <= kMaxVertices;
  if (!has_vertices || manifuzz::find_defect(polygon.corners())) return Defect::shape_not_convex;
  double squared = 0;
  double sharpness = 1;
  for (int i = 0; i < polygon.count; ++i) {
    const Vector2<double> v = polygon.vertices[i].cast<double>();
    squared = std::max(squared, v.dot(v));
    sharpness = std::min(sharpness, half_angle_sine(polygon, i));
  }
  const double reach = std::sqrt(squared);
  const double length_max = static_cast<double>(kLengthMax);
  const bool is_radius = polygon.radius >= 0 && polygon.radius <= kLengthMax;
  if (!(reach <= length_max) || !is_radius) return Defect::shape_too_large;
  if (!(sharpness >= kSharpnessMin)) return Defect::shape_too_sharp;
  const float reach_up = static_cast<float>(reach * kUpward);
  facts_.push_back(
      {reach_up, polygon.radius, padding(reach_up, polygon.radius + tie_bias_, sharpness)});
  rows_.push_back(*kernel::rows_of(polygon));
  return *for_pairs_.add(polygon);
}

}  // namespace manifuzz::scene
