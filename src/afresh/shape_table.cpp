#include "afresh/shape_table.hpp"

#include "afresh/lists.hpp"

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

/// A round shape touches what comes as near as its radius, whatever its corners.
float padding_of_round(float reach, float radius) {
  return radius + 13 * kSeparationError * (reach + radius) + kUnderflow;
}

/// The least sine of half the angle at any corner (`half_angle_sine`).
double sharpness_of(const ConvexPolygon<float>& polygon) {
  double sharpness = 1;
  for (int i = 0; i < polygon.count; ++i) {
    sharpness = std::min(sharpness, half_angle_sine(polygon, i));
  }
  return sharpness;
}

}  // namespace

std::variant<std::uint32_t, Defect> ShapeTable::add(const ConvexPolygon<float>& shape) {
  const bool has_vertices = shape.count > 0 && shape.count <= kMaxVertices;
  const bool is_core = shape.count >= kMinVertices || shape.is_round();
  const bool is_radius = shape.radius >= 0 && shape.radius <= kLengthMax;
  if (!has_vertices || !is_core) return Defect::shape_not_convex;
  if (!is_radius) return Defect::shape_too_large;
  if (find_shape_defect(shape.corners(), shape.radius)) return Defect::shape_not_convex;
  const double reach = manifuzz::reach(shape);
  if (!(reach <= static_cast<double>(kLengthMax))) return Defect::shape_too_large;
  const float reach_up = static_cast<float>(reach * kUpward);
  float padded_by = padding_of_round(reach_up, shape.radius);
  if (!shape.is_round()) {
    const double sharpness = sharpness_of(shape);
    if (!(sharpness >= kSharpnessMin)) return Defect::shape_too_sharp;
    padded_by = padding(reach_up, shape.radius + tie_bias_, sharpness);
  }
  make_room(facts_, facts_.size() + 1);
  make_room(rows_, rows_.size() + 1);
  const std::uint32_t index = for_pairs_.add(shape);
  const float rounding = kSeparationError * (reach_up + shape.radius);
  const auto clearance = [&](float padding) {
    return shape.radius + rounding + 1.001F * (padding - shape.radius);
  };
  facts_.push_back({reach_up, shape.radius, padded_by, clearance(padded_by),
                    clearance(padding_of_round(reach_up, shape.radius))});
  rows_.push_back(kernel::rows_of(shape));
  return index;
}

}  // namespace manifuzz::scene
