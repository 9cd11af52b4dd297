#include "scene/scene.hpp"

#include <bit>

namespace manifuzz::scene {
namespace {

bool same_bits(const Vector2<float>& v, const Vector2<float>& w) {
  const auto bits = [](float x) { return std::bit_cast<std::uint32_t>(x); };
  return bits(v.x()) == bits(w.x()) && bits(v.y()) == bits(w.y());
}

bool same_bits(const Pose<float>& p, const Pose<float>& q) {
  return same_bits(p.position, q.position) && same_bits(p.rotation, q.rotation);
}

}  // namespace

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
  pairs_.remove_each(body.index, [&](std::uint32_t pair, std::uint32_t) {
    end_contact(pair);
    return true;
  });
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

void Scene::begin_contact(std::uint32_t pair) {
  const auto [a, b] = pairs_[pair].bodies;
  pairs_[pair].contact = static_cast<std::uint32_t>(contacts_.size());
  contacts_.push_back({handle(a), handle(b), {}});
  began_.push_back(pair);
}

/// The last contact takes the ended one's index.
void Scene::end_contact(std::uint32_t pair) {
  const std::uint32_t contact = pairs_[pair].contact;
  if (contact == kNone) return;
  ended_.push_back({contacts_[contact].a, contacts_[contact].b});
  const Contact& last = contacts_.back();
  pairs_[pairs_.find(last.a.index, last.b.index)].contact = contact;
  contacts_[contact] = last;
  contacts_.pop_back();
  if (!collided_.empty()) {
    collided_[contact] = collided_.back();
    collided_.pop_back();
  }
  pairs_[pair].contact = kNone;
}

Memory Scene::memory() const {
  const auto of = [](const auto& vector) { return vector.capacity() * sizeof(vector[0]); };
  return {of(placements_) + of(generations_) + of(free_) + of(changes_) + of(changed_) +
              broad_phase_.bytes() + pairs_.bytes_by_body(),
          pairs_.bytes_by_pair() + of(contacts_) + of(collided_) + of(waiting_) +
              of(waiting_bodies_) + of(manifolds_) + of(began_) + of(ended_)};
}

}  // namespace manifuzz::scene
