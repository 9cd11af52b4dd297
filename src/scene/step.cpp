#include <iterator>
#include <utility>

#include "kernel/batch.hpp"
#include "scene/pair_cache.hpp"
#include "scene/scene.hpp"

namespace manifuzz::scene {
namespace {

/// Pairs that are collided together: enough for the kernel to sort, few enough for the cache.
constexpr std::size_t kWaitingMax = 4096;

/// Once one body in so many moved, all pairs are gone through, in the order of memory.
constexpr std::size_t kAllPairsShare = 16;

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
  begin_and_end();
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
    const bool is_alone = broad_phase_.holds(body) && !pairs_.has_any(body);
    const Fatness& fatness = is_alone ? kAlone : kAmongOthers;
    if (!broad_phase_.update(body, box, pose, facts.reach, fatness)) continue;
    changes_[body] = kLeftBox;
    ++counts_.left_boxes;
  }
  for (const std::uint32_t body : changed_) {
    if (changes_[body] != kLeftBox) continue;
    find_partners(body);
  }
}

void Scene::find_partners(std::uint32_t body) {
  ++search_;
  counts_.pairs_dropped += drop_pairs(body, [&](std::uint32_t other) {
    known_in_[other] = search_;
    return !broad_phase_.overlap(body, other);
  });
  broad_phase_.partners(body, [&](std::uint32_t other) {
    if (known_in_[other] == search_) return;
    pairs_.add(body, other);
    ++counts_.pairs_added;
  });
}

void Scene::look_at_pairs() {
  if (kAllPairsShare * changed_.size() >= body_count_) {
    const auto moved = [&](std::uint32_t pair) {
      const auto [a, b] = pairs_[pair].bodies;
      return changes_[a] != kUnchanged || changes_[b] != kUnchanged;
    };
    const auto count = static_cast<std::uint32_t>(pairs_.size());
    for (std::uint32_t pair = 0; pair < pairs_.touching(); ++pair) {
      if (moved(pair)) look_at_touching(pair);
    }
    for (std::uint32_t pair = pairs_.touching(); pair < count; ++pair) {
      if (moved(pair)) look_at_apart(pair);
    }
  } else {
    for (const std::uint32_t body : changed_) {
      pairs_.each_of(body, [&](std::uint32_t pair, std::uint32_t other) {
        const bool is_others = changes_[other] != kUnchanged && other < body;
        if (!is_others) pair < pairs_.touching() ? look_at_touching(pair) : look_at_apart(pair);
      });
    }
  }
  collide_waiting();
}

bool Scene::is_proven(std::uint32_t pair) const {
  const auto& [bodies, certificate] = pairs_[pair];
  return still_holds(certificate, shapes_, placements_[bodies.a], placements_[bodies.b]);
}

void Scene::look_at_touching(std::uint32_t pair) {
  if (settings_.recycled_motion > 0 && is_proven(pair)) return recycle(pair);
  wait(pair);
}

void Scene::look_at_apart(std::uint32_t pair) {
  if (!settings_.certificates || !is_proven(pair)) return wait(pair);
  ++counts_.pairs.separated;
}

void Scene::wait(std::uint32_t pair) {
  waiting_.push_back(pair);
  waiting_bodies_.push_back(pairs_[pair].bodies);
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

/// Pairs that begin or end to touch are put where they belong at the end: until then all keep their
/// indices.
void Scene::conclude(std::uint32_t pair, const Manifold<float>& manifold) {
  const kernel::BodyPair bodies = pairs_[pair].bodies;
  const bool touched = pair < pairs_.touching();
  if (manifold.count > 0) {
    if (touched) {
      contacts_[pair].manifold = manifold;
      if (settings_.recycled_motion > 0) keep_for_recycling(pair);
    } else {
      beginning_.push_back({handle(bodies.a), handle(bodies.b), manifold});
    }
    return;
  }
  if (touched) ending_.push_back(bodies);
  if (!settings_.certificates) return;
  pairs_[pair].certificate = prove_separated(shapes_, placements_[bodies.a], placements_[bodies.b]);
  ++counts_.proofs;
}

void Scene::begin_and_end() {
  for (const kernel::BodyPair& bodies : ending_) end_contact(pairs_.find(bodies.a, bodies.b));
  for (const Contact& contact : beginning_) begin_contact(contact);
  ending_.clear();
  beginning_.clear();
  if (beginning_.capacity() > kWaitingMax)
    beginning_ = std::vector<Contact>();  // a first step's are no measure
}

void Scene::keep_for_recycling(std::uint32_t pair) {
  collided_.resize(contacts_.size());
  collided_[pair] = contacts_[pair].manifold;
  pairs_[pair].certificate = {b_in_a(pairs_[pair].bodies), settings_.recycled_motion, Side::a};
}

/// From what the kernel gave, whenever that was: nothing accumulates.
void Scene::recycle(std::uint32_t pair) {
  const auto& [bodies, certificate] = pairs_[pair];
  contacts_[pair].manifold = recycled(collided_[pair], certificate.far_in_near, b_in_a(bodies));
  ++counts_.pairs.recycled;
}

StepResult Scene::result() {
  PairCounts& pairs = counts_.pairs;
  pairs.candidates = pairs_.size();
  pairs.at_rest = pairs.candidates - pairs.separated - pairs.recycled - pairs.collided;
  ended_reported_ = std::ssize(ended_);
  const std::size_t stayed = contacts_.size() - began_.size();
  return {contacts_, began_, ended_, stayed, counts_};
}

}  // namespace manifuzz::scene
