#include "scene/scene.hpp"

#include <cassert>

#include "geometry/manifold.hpp"

namespace manifuzz::scene {

std::optional<Defect> find_defect(const Settings& settings) {
  for (const float length : {settings.tie_bias, settings.recycled_motion}) {
    if (!(length >= 0 && length <= kLengthMax)) return Defect::setting_not_a_length;
  }
  return std::nullopt;
}

Scene::Scene(const Settings& settings) : settings_(settings), shapes_(settings.tie_bias) {
  assert(!find_defect(settings));
}

std::variant<std::uint32_t, Defect> Scene::add_shape(const ConvexPolygon<float>& polygon) {
  return shapes_.add(polygon);
}

std::variant<BodyHandle, Defect> Scene::add(std::uint32_t shape, const Pose<float>& pose) {
  if (shape >= shapes_.size()) return Defect::unknown_shape;
  if (const auto defect = find_defect(pose)) return *defect;
  if (free_.empty()) {
    free_.push_back(static_cast<std::uint32_t>(placements_.size()));
    placements_.emplace_back();
    generations_.push_back(0);
    changes_.push_back(kUnchanged);
    known_in_.push_back(0);
  }
  const std::uint32_t body = free_.back();
  free_.pop_back();
  placements_[body] = {shape, pose};
  ++generations_[body];
  ++body_count_;
  mark_changed(body);
  return handle(body);
}

std::optional<Defect> Scene::remove(BodyHandle body) {
  if (!is_known(body)) return Defect::unknown_body;
  drop_pairs(body.index, [](std::uint32_t) { return true; });
  broad_phase_.remove(body.index);
  ++generations_[body.index];
  --body_count_;
  free_.push_back(body.index);
  return std::nullopt;
}

std::optional<Defect> Scene::set_shape(BodyHandle body, std::uint32_t shape) {
  if (!is_known(body)) return Defect::unknown_body;
  if (shape >= shapes_.size()) return Defect::unknown_shape;
  placements_[body.index].shape = shape;
  pairs_.each_of(body.index,
                 [&](std::uint32_t pair, std::uint32_t) { pairs_[pair].certificate = {}; });
  broad_phase_.forget_slack(body.index);
  mark_changed(body.index);
  return std::nullopt;
}

void Scene::mark_changed(std::uint32_t body) {
  if (changes_[body] != kUnchanged) return;
  changes_[body] = kChanged;
  changed_.push_back(body);
}

void Scene::place(const Move& move) {
  Pose<float>& pose = placements_[move.body.index].pose;
  if (same_bits(pose, move.pose)) return;
  pose = move.pose;
  mark_changed(move.body.index);
}

void Scene::begin_contact(const Contact& contact) {
  const std::uint32_t pair = pairs_.find(contact.a.index, contact.b.index);
  pairs_.begin_touching(pair);
  began_.push_back(static_cast<std::uint32_t>(contacts_.size()));
  contacts_.push_back(contact);
  if (settings_.recycled_motion > 0) keep_for_recycling(began_.back());
}

std::uint32_t Scene::end_contact(std::uint32_t pair) {
  ended_.push_back({contacts_[pair].a, contacts_[pair].b});
  contacts_[pair] = contacts_.back();
  contacts_.pop_back();
  if (!collided_.empty()) {
    collided_[pair] = collided_.back();
    collided_.pop_back();
  }
  return pairs_.end_touching(pair);
}

Memory Scene::memory() const {
  const auto of = [](const auto& vector) { return vector.capacity() * sizeof(vector[0]); };
  return {of(placements_) + of(generations_) + of(free_) + of(changes_) + of(changed_) +
              of(known_in_) + broad_phase_.bytes() + pairs_.bytes_by_body(),
          pairs_.bytes_by_pair() + of(contacts_) + of(collided_) + of(waiting_) +
              of(waiting_bodies_) + of(manifolds_) + of(began_) + of(ended_) + of(beginning_) +
              of(ending_) + of(gone_)};
}

}  // namespace manifuzz::scene
