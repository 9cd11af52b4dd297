#include "scene/box.hpp"

#include "scene/roundings.hpp"

namespace manifuzz::scene {

Box padded_box(const kernel::ShapeRows& shape, const Pose<float>& pose, float padding) {
  const float c = pose.rotation.x();
  const float s = pose.rotation.y();
  float x[kMaxVertices];
  float y[kMaxVertices];
  for (int i = 0; i < kMaxVertices; ++i) {
    x[i] = c * shape.x[i] - s * shape.y[i];
    y[i] = s * shape.x[i] + c * shape.y[i];
  }
  Box box{x[0], y[0], x[0], y[0]};
  for (int i = 1; i < kMaxVertices; ++i) {
    box = {std::min(box.x_min, x[i]), std::min(box.y_min, y[i]), std::max(box.x_max, x[i]),
           std::max(box.y_max, y[i])};
  }
  const float p_x = pose.position.x();
  const float p_y = pose.position.y();
  const float pad = padding + 4 * kRoundoff * (std::abs(p_x) + std::abs(p_y));
  return grown({box.x_min + p_x, box.y_min + p_y, box.x_max + p_x, box.y_max + p_y}, pad);
}

}  // namespace manifuzz::scene
