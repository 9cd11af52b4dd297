#include "scene/broad_phase.hpp"

#include <algorithm>
#include <limits>

namespace manifuzz::scene {
namespace {

/// Holds no box.
constexpr Box kNowhere{std::numeric_limits<float>::infinity(), 0,
                       -std::numeric_limits<float>::infinity(), 0};

/// The box fattened all round, and ahead of where the body comes from.
Box fattened(const Box& box, const Vector2<float>& motion, float reach) {
  const auto ahead = [&](float way) { return std::clamp(kFatAhead * way, 0.0F, reach); };
  Box fat = grown(box, kFatShare * reach);
  fat.x_min -= ahead(-motion.x());
  fat.y_min -= ahead(-motion.y());
  fat.x_max += ahead(motion.x());
  fat.y_max += ahead(motion.y());
  return fat;
}

}  // namespace

bool BroadPhase::update(std::uint32_t body, const Box& box, const Pose<float>& pose, float reach) {
  if (body >= fat_boxes_.size()) {
    fat_boxes_.resize(body + 1, kNowhere);
    anchors_.resize(body + 1);
  }
  Box& fat_box = fat_boxes_[body];
  Anchor& anchor = anchors_[body];
  const bool is_new = fat_box.x_min > fat_box.x_max;
  const bool left = !contains(fat_box, box);
  if (left) {
    const Vector2<float> motion =
        is_new ? Vector2<float>(0, 0) : pose.position - anchor.pose.position;
    fat_box = fattened(box, motion, reach);
    grid_.place(body, fat_box);
  }
  anchor = {pose, slack(fat_box, box)};
  return left;
}

void BroadPhase::remove(std::uint32_t body) {
  if (body >= fat_boxes_.size() || fat_boxes_[body].x_min > fat_boxes_[body].x_max) return;
  grid_.remove(body);
  fat_boxes_[body] = kNowhere;
  anchors_[body].slack = 0;
}

}  // namespace manifuzz::scene
