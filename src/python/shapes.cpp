#include "python/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

namespace manifuzz::python {
namespace {

std::optional<PolygonDefect> defect_in(std::span<const Vector2<float>> vertices, float radius) {
  return find_shape_defect(vertices, radius);
}

/// What is wrong with a circle or a capsule does not depend on the scalar, but for what is beyond
/// floats.
std::optional<PolygonDefect> defect_in(std::span<const Vector2<double>> vertices, double radius) {
  if (vertices.empty()) return PolygonDefect::too_few;
  if (vertices.size() >= kMinVertices) {
    if (const auto defect = find_defect_in_doubles(vertices)) return defect;
  } else {
    if (!std::ranges::all_of(vertices, [](const auto& v) { return v.allFinite(); })) {
      return PolygonDefect::not_finite;
    }
    if (vertices.size() == 2 && vertices[0] == vertices[1]) return PolygonDefect::repeated_vertex;
  }
  if (!(radius >= 0) || std::isinf(radius)) return PolygonDefect::radius_not_a_length;
  if (vertices.size() == 1 && !(radius > 0)) return PolygonDefect::no_radius;
  return std::nullopt;
}

}  // namespace

template <class Scalar>
ConvexPolygon<Scalar> checked_shape(std::span<const ShapeRecord<Scalar>> shapes, std::size_t index,
                                    std::string_view array) {
  const ShapeRecord<Scalar>& shape = shapes[index];
  if (shape.count < 1 || shape.count > kMaxVertices) {
    throw nanobind::value_error(
        fmt::format("{}[{}]: {} vertices; a shape has 1 to 8", array, index, shape.count).c_str());
  }
  std::array<Vector2<Scalar>, kMaxVertices> vertices;
  for (int i = 0; i < shape.count; ++i) vertices[i] = {shape.vertices[i][0], shape.vertices[i][1]};
  const std::span<const Vector2<Scalar>> corners{vertices.data(),
                                                 static_cast<std::size_t>(shape.count)};
  if (const auto defect = defect_in(corners, shape.radius)) {
    throw nanobind::value_error(fmt::format("{}[{}]: {}", array, index, describe(*defect)).c_str());
  }
  return make_polygon(corners, shape.radius, shape.rounding);
}

template ConvexPolygon<float> checked_shape(std::span<const ShapeRecord<float>>, std::size_t,
                                            std::string_view);
template ConvexPolygon<double> checked_shape(std::span<const ShapeRecord<double>>, std::size_t,
                                             std::string_view);

ShapeRecord<float> record_of(const ConvexPolygon<float>& shape) {
  ShapeRecord<float> record{};
  for (int i = 0; i < shape.count; ++i) {
    record.vertices[i] = {shape.vertices[i].x(), shape.vertices[i].y()};
  }
  record.radius = shape.radius;
  record.count = shape.count;
  record.rounding = shape.rounding;
  return record;
}

template <class Scalar>
void expect_pose(const Pose<Scalar>& pose, std::string_view array, std::size_t index) {
  if (pose.position.allFinite() && is_unit_rotation(pose.rotation)) return;
  const auto complaint =
      pose.position.allFinite()
          ? fmt::format("{}[{}]: (cos, sin) is ({}, {}); its length must be 1 within 5e-6", array,
                        index, pose.rotation.x(), pose.rotation.y())
          : fmt::format("{}[{}]: the position is ({}, {}); finite numbers are expected", array,
                        index, pose.position.x(), pose.position.y());
  throw nanobind::value_error(complaint.c_str());
}

template void expect_pose(const Pose<float>&, std::string_view, std::size_t);
template void expect_pose(const Pose<double>&, std::string_view, std::size_t);

template <class Scalar>
Pose<Scalar> checked_pose(std::span<const PosesRecord<Scalar>> poses, std::size_t index,
                          Side side) {
  const Pose<Scalar> pose = pose_of(poses[index][side == Side::a ? 0 : 1]);
  expect_pose(pose, "poses", index);
  return pose;
}

template Pose<float> checked_pose(std::span<const PosesRecord<float>>, std::size_t, Side);
template Pose<double> checked_pose(std::span<const PosesRecord<double>>, std::size_t, Side);

}  // namespace manifuzz::python
