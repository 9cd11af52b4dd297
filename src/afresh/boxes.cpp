#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "afresh/boxes.cpp"
#include <hwy/foreach_target.h>  // includes this file once more for every other target
// after foreach_target
#include <cassert>
#include <hwy/highway.h>

#include "afresh/boxes.hpp"

HWY_BEFORE_NAMESPACE();
namespace manifuzz::scene::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The box of a shape's vertices, turned: a vertex a lane.
HWY_INLINE Box box_of(const kernel::ShapeRows& shape, const Vector2<float>& rotation) {
  const hn::CappedTag<float, kMaxVertices> d;
  const auto c = hn::Set(d, rotation.x());
  const auto s = hn::Set(d, rotation.y());
  auto x_min = hn::Set(d, std::numeric_limits<float>::infinity());
  auto y_min = x_min;
  auto x_max = hn::Neg(x_min);
  auto y_max = x_max;
  for (std::size_t i = 0; i < kMaxVertices; i += hn::Lanes(d)) {
    const auto v_x = hn::Load(d, shape.x + i);
    const auto v_y = hn::Load(d, shape.y + i);
    const auto x = hn::Sub(hn::Mul(c, v_x), hn::Mul(s, v_y));
    const auto y = hn::Add(hn::Mul(s, v_x), hn::Mul(c, v_y));
    x_min = hn::Min(x_min, x);
    y_min = hn::Min(y_min, y);
    x_max = hn::Max(x_max, x);
    y_max = hn::Max(y_max, y);
  }
  const auto least = [d](auto v) { return hn::GetLane(hn::MinOfLanes(d, v)); };
  const auto greatest = [d](auto v) { return hn::GetLane(hn::MaxOfLanes(d, v)); };
  return {least(x_min), least(y_min), greatest(x_max), greatest(y_max)};
}

void padded_boxes(const ShapeTable& shapes, std::span<const kernel::Placement<float>> placements,
                  std::span<const std::uint32_t> bodies, std::span<Box> out) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const auto& [shape, pose] = placements[bodies[i]];
    const Vector2<float>& p = pose.position;
    const Box box = box_of(shapes.rows(shape), pose.rotation);
    const float pad =
        shapes.facts(shape).padding + 4 * kRoundoff * (std::abs(p.x()) + std::abs(p.y()));
    out[i] =
        grown({box.x_min + p.x(), box.y_min + p.y(), box.x_max + p.x(), box.y_max + p.y()}, pad);
  }
}

}  // namespace manifuzz::scene::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace manifuzz::scene {

HWY_EXPORT(padded_boxes);

void padded_boxes(const ShapeTable& shapes, std::span<const kernel::Placement<float>> placements,
                  std::span<const std::uint32_t> bodies, std::span<Box> out) {
  assert(out.size() >= bodies.size());
  HWY_DYNAMIC_DISPATCH(padded_boxes)(shapes, placements, bodies, out);
}

}  // namespace manifuzz::scene
#endif
