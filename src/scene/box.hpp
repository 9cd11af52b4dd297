#pragma once

#include "scene/roundings.hpp"
#include "scene/shape_table.hpp"

namespace manifuzz::scene {

/// Parallel to the axes of the world, with its edge; world lengths.
struct Box {
  float x_min = 0;
  float y_min = 0;
  float x_max = 0;
  float y_max = 0;
};

/// Whether two boxes have a point in common; without branches, which no processor could foretell
/// here.
inline bool overlap(const Box& p, const Box& q) {
  const int in_x = static_cast<int>(p.x_min <= q.x_max) & static_cast<int>(q.x_min <= p.x_max);
  const int in_y = static_cast<int>(p.y_min <= q.y_max) & static_cast<int>(q.y_min <= p.y_max);
  return (in_x & in_y) != 0;
}

/// Whether no point of the inner box is outside the outer one.
inline bool contains(const Box& outer, const Box& inner) {
  return outer.x_min <= inner.x_min && outer.y_min <= inner.y_min && outer.x_max >= inner.x_max &&
         outer.y_max >= inner.y_max;
}

/// How far the inner box may grow all round without leaving the outer one, rounded down.
inline float slack(const Box& outer, const Box& inner) {
  const float x = std::min(inner.x_min - outer.x_min, outer.x_max - inner.x_max);
  const float y = std::min(inner.y_min - outer.y_min, outer.y_max - inner.y_max);
  return kRoundDown * std::min(x, y);
}

/// The box, larger by a length on each of its sides.
inline Box grown(const Box& box, float by) {
  return {box.x_min - by, box.y_min - by, box.x_max + by, box.y_max + by};
}

/// The box of a shape at a pose in the world, larger on each side by `padding` (a length) and by
/// what rounding its position takes.
Box padded_box(const kernel::ShapeRows& shape, const Pose<float>& pose, float padding);

}  // namespace manifuzz::scene
