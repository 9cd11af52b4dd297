#include <algorithm>

#include "scene/scene.hpp"

// What a scene is once memory has run out.

namespace manifuzz::scene {

/// Whatever was under way, what is left is right: bodies that stand somewhere, of whose pairs
/// nothing is known. Needs no memory.
void Scene::forget_pairs() {
  division_.forget();
  has_forgotten_ = true;
  cells_ = {};
  candidates_ = {};
  const auto clear = [](auto&... lists) { (lists.clear(), ...); };
  clear(contacts_, kept_, left_, mover_works_, left_works_, partner_works_, pair_works_, vacant_);
  clear(began_, ended_, renumbered_);
  ended_reported_ = renumbered_reported_ = 0;
  counts_ = {};
  compared_ = 0;
  std::ranges::fill(boxes_, kNowhere);
  std::ranges::fill(states_, std::uint8_t{0});
}

/// All are looked at as if they had just been added. Where memory ran out while moves were placed,
/// some parts of a body may have been, and others not.
void Scene::recall_bodies() {
  for (const auto& [place, assembly] : assemblies_) {
    for (const Assembly::Part& part : assembly.parts) {
      placements_[part.handle.index].pose = composed(assembly.pose, part.pose);
    }
  }
  movers_.clear();
  unsure_.clear();
  make_room(movers_, body_count_);
  for (std::uint32_t body = 0; body < generations_.size(); ++body) {
    states_[body] = 0;
    if (generations_[body] % 2 == 1) start_path(body);
  }
  has_forgotten_ = false;
}

}  // namespace manifuzz::scene
