#include <iterator>
#include <utility>

#include "kernel/batch.hpp"
#include "scene/recycled.hpp"
#include "scene/scene.hpp"

namespace manifuzz::scene {
namespace {

/// Pairs that are collided together: enough for the kernel to sort, few enough for the cache.
constexpr std::size_t kWaitingMax = 4096;

/// Once one body in so many moved, all pairs are gone through, in the order of memory.
constexpr std::size_t kAllPairsShare = 4;

}  // namespace

std::variant<StepResult, RefusedMove> Scene::step(std::span<const Move> moves) {
  for (std::size_t i = 0; i < moves.size(); ++i) {
    if (!is_known(moves[i].body)) return RefusedMove{i, Defect::unknown_body};
    if (const auto defect = find_defect(moves[i].pose)) return RefusedMove{i, *defect};
  }
  counts_ = {};
  began_.clear();
  ended_.erase(ended_.begin(), ended_.begin() + std::exchange(ended_reported_, 0));
  for (const Move& move : moves) place(move);
  find_candidates();
  look_at_pairs();
  for (const std::uint32_t body : changed_) changes_[body] = kUnchanged;
  changed_.clear();
  return result();
}

void Scene::find_candidates() {
  std::erase_if(changed_, [&](std::uint32_t body) {
    const bool is_gone = generations_[body] % 2 == 0;
    if (is_gone) changes_[body] = kUnchanged;
    return is_gone;
  });
  counts_.moved = changed_.size();
  for (const std::uint32_t body : changed_) {
    const auto& [shape, pose] = placements_[body];
    const ShapeFacts& facts = shapes_.facts(shape);
    if (broad_phase_.is_still_inside(body, pose, facts.reach)) continue;
    const Box box = padded_box(shapes_.rows(shape), pose, facts.padding);
    if (!broad_phase_.update(body, box, pose, facts.reach)) continue;
    changes_[body] = kLeftBox;
    ++counts_.left_boxes;
  }
  for (const std::uint32_t body : changed_) {
    if (changes_[body] != kLeftBox) continue;
    drop_candidates(body);
    broad_phase_.partners(body, [&](std::uint32_t other) {
      if (pairs_.find(body, other) != kNone) return;
      pairs_.add(body, other);
      ++counts_.pairs_added;
    });
  }
}

void Scene::drop_candidates(std::uint32_t body) {
  pairs_.remove_each(body, [&](std::uint32_t pair, std::uint32_t other) {
    if (broad_phase_.overlap(body, other)) return false;
    end_contact(pair);
    ++counts_.pairs_dropped;
    return true;
  });
}

void Scene::look_at_pairs() {
  if (kAllPairsShare * changed_.size() >= body_count_) {
    const auto count = static_cast<std::uint32_t>(pairs_.size());
    for (std::uint32_t pair = 0; pair < count; ++pair) {
      const auto [a, b] = pairs_[pair].bodies;
      if (changes_[a] != kUnchanged || changes_[b] != kUnchanged) look_at(pair);
    }
  } else {
    for (const std::uint32_t body : changed_) {
      pairs_.each_of(body, [&](std::uint32_t pair, std::uint32_t other) {
        const bool is_others = changes_[other] != kUnchanged && other < body;
        if (!is_others) look_at(pair);
      });
    }
  }
  collide_waiting();
}

void Scene::look_at(std::uint32_t pair) {
  const auto& [bodies, contact, certificate] = pairs_[pair];
  if (still_holds(certificate, shapes_, placements_[bodies.a], placements_[bodies.b])) {
    if (contact == kNone) {
      ++counts_.pairs.separated;
    } else {
      recycle(pair);
    }
    return;
  }
  waiting_.push_back(pair);
  waiting_bodies_.push_back(bodies);
  if (waiting_.size() == kWaitingMax) collide_waiting();
}

void Scene::collide_waiting() {
  manifolds_.resize(std::max(manifolds_.size(), waiting_.size()));
  kernel::collide_pairs(shapes_.for_pairs(), placements_, waiting_bodies_, settings_.tie_bias,
                        manifolds_);
  for (std::size_t i = 0; i < waiting_.size(); ++i) conclude(waiting_[i], manifolds_[i]);
  counts_.pairs.collided += waiting_.size();
  waiting_.clear();
  waiting_bodies_.clear();
}

void Scene::conclude(std::uint32_t pair, const Manifold<float>& manifold) {
  const kernel::BodyPair bodies = pairs_[pair].bodies;
  if (manifold.count > 0) {
    if (pairs_[pair].contact == kNone) begin_contact(pair);
    contacts_[pairs_[pair].contact].manifold = manifold;
    pairs_[pair].certificate = {};
    if (settings_.recycled_motion > 0) keep_for_recycling(pair);
    return;
  }
  end_contact(pair);
  pairs_[pair].certificate = prove_separated(shapes_, placements_[bodies.a], placements_[bodies.b]);
  ++counts_.proofs;
}

void Scene::keep_for_recycling(std::uint32_t pair) {
  const auto& [bodies, contact, certificate] = pairs_[pair];
  collided_.resize(contacts_.size());
  collided_[contact] = contacts_[contact].manifold;
  pairs_[pair].certificate = {b_in_a(bodies), settings_.recycled_motion, Side::a};
}

/// From what the kernel gave, whenever that was: nothing accumulates.
void Scene::recycle(std::uint32_t pair) {
  const auto& [bodies, contact, certificate] = pairs_[pair];
  contacts_[contact].manifold =
      recycled(collided_[contact], certificate.far_in_near, b_in_a(bodies));
  ++counts_.pairs.recycled;
}

StepResult Scene::result() {
  for (std::uint32_t& pair : began_) pair = pairs_[pair].contact;
  counts_.bodies = body_count_;
  PairCounts& pairs = counts_.pairs;
  pairs.candidates = pairs_.size();
  pairs.at_rest = pairs.candidates - pairs.separated - pairs.recycled - pairs.collided;
  ended_reported_ = std::ssize(ended_);
  return {contacts_, began_, ended_, contacts_.size() - began_.size(), counts_};
}

}  // namespace manifuzz::scene
