#include "scene/broad_phase.hpp"

#include <limits>

namespace manifuzz::scene {
namespace {

/// Holds no box.
constexpr Box kNowhere{std::numeric_limits<float>::infinity(), 0,
                       -std::numeric_limits<float>::infinity(), 0};

}  // namespace

bool BroadPhase::update(std::uint32_t body, const Box& box, float margin) {
  if (body >= fat_boxes_.size()) fat_boxes_.resize(body + 1, kNowhere);
  Box& fat_box = fat_boxes_[body];
  if (contains(fat_box, box)) return false;
  fat_box = grown(box, margin);
  grid_.place(body, fat_box);
  return true;
}

void BroadPhase::remove(std::uint32_t body) {
  if (body >= fat_boxes_.size() || fat_boxes_[body].x_min > fat_boxes_[body].x_max) return;
  grid_.remove(body);
  fat_boxes_[body] = kNowhere;
}

}  // namespace manifuzz::scene
