#include "scene/broad_phase.hpp"

#include <algorithm>
#include <limits>

namespace manifuzz::scene {
namespace {

/// The box fattened all round, and ahead of where the body comes from.
Box fattened(const Box& box, const Vector2<float>& motion, float reach, const Fatness& fatness) {
  const float ahead_max = fatness.ahead_max * reach;
  const auto ahead = [&](float way) { return std::clamp(fatness.ahead * way, 0.0F, ahead_max); };
  Box fat = grown(box, fatness.all_round * reach);
  fat.x_min -= ahead(-motion.x());
  fat.y_min -= ahead(-motion.y());
  fat.x_max += ahead(motion.x());
  fat.y_max += ahead(motion.y());
  return fat;
}

}  // namespace

bool BroadPhase::update(std::uint32_t body, const Box& box, const Pose<float>& pose, float reach,
                        const Fatness& fatness) {
  if (body >= anchors_.size()) anchors_.resize(body + 1);
  Anchor& anchor = anchors_[body];
  const bool is_new = !grid_.holds(body);
  const bool left = is_new || !contains(grid_.box(body), box);
  if (left) {
    const Vector2<float> motion =
        is_new ? Vector2<float>(0, 0) : Vector2<float>(pose.position - anchor.pose.position);
    grid_.place(body, fattened(box, motion, reach, fatness));
  }
  anchor = {pose, slack(grid_.box(body), box)};
  return left;
}

void BroadPhase::remove(std::uint32_t body) {
  if (!grid_.holds(body)) return;
  grid_.remove(body);
  anchors_[body].slack = 0;
}

}  // namespace manifuzz::scene
