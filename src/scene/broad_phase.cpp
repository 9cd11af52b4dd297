#include "scene/broad_phase.hpp"

#include <algorithm>
#include <limits>

namespace manifuzz::scene {
namespace {

/// Holds no box.
constexpr Box kNowhere{std::numeric_limits<float>::infinity(), 0,
                       -std::numeric_limits<float>::infinity(), 0};

/// How far to fatten ahead of a side that went by `step`.
float ahead(float step, float reach) {
  return std::clamp(kFatSteps * step, 0.0F, reach);
}

/// The box fattened all round, and ahead of where it comes from.
Box fattened(const Box& box, const Box& before, float reach) {
  Box fat = grown(box, kFatShare * reach);
  fat.x_min -= ahead(before.x_min - box.x_min, reach);
  fat.y_min -= ahead(before.y_min - box.y_min, reach);
  fat.x_max += ahead(box.x_max - before.x_max, reach);
  fat.y_max += ahead(box.y_max - before.y_max, reach);
  return fat;
}

}  // namespace

bool BroadPhase::update(std::uint32_t body, const Box& box, float reach) {
  if (body >= fat_boxes_.size()) {
    fat_boxes_.resize(body + 1, kNowhere);
    boxes_.resize(body + 1);
  }
  Box& fat_box = fat_boxes_[body];
  const bool is_new = fat_box.x_min > fat_box.x_max;
  const Box before = is_new ? box : boxes_[body];
  boxes_[body] = box;
  if (contains(fat_box, box)) return false;
  fat_box = fattened(box, before, reach);
  grid_.place(body, fat_box);
  return true;
}

void BroadPhase::remove(std::uint32_t body) {
  if (body >= fat_boxes_.size() || fat_boxes_[body].x_min > fat_boxes_[body].x_max) return;
  grid_.remove(body);
  fat_boxes_[body] = kNowhere;
}

}  // namespace manifuzz::scene
