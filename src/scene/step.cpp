#include <algorithm>
#include <array>
#include <utility>

#include "scene/scene.hpp"

namespace manifuzz::scene {

std::variant<StepResult, RefusedMove> Scene::step(std::span<const Move> moves,
                                                  const Executor& executor) {
  division_.set_executor(executor);
  const auto [refused, may_divide] = check(moves);
  if (refused) {
    division_.forget_executor();
    return *refused;
  }
  try {
    advance(moves, may_divide);
  } catch (...) {
    forget_pairs();
    throw;
  }
  division_.forget_executor();
  return result();
}

void Scene::advance(std::span<const Move> moves, bool may_divide) {
  if (has_forgotten_) recall_bodies();
  began_.clear();
  ended_.erase(ended_.begin(), ended_.begin() + std::exchange(ended_reported_, 0));
  renumbered_.erase(renumbered_.begin(),
                    renumbered_.begin() + std::exchange(renumbered_reported_, 0));
  const std::span<const Move> of_parts = moves_of_parts(moves);
  if (!assemblies_.empty()) {
    may_divide = division_.tasks_for(of_parts.size()) > 1 && do_ascend(of_parts);
  }
  place(of_parts, may_divide);
  renew_boxes();
  look_at_candidates();
  begin_contacts();
  drop_parted();
  add_candidates();
  settle();
}

/// What happened to the bodies is over.
void Scene::settle() {
  const auto settled = [](std::uint8_t& state) {
    state = static_cast<std::uint8_t>(state & (kFiled | kAlone | kFewPartners | kBoxed));
  };
  if (few_moved_) {
    for (const std::uint32_t body : movers_) settled(states_[body]);
  } else {
    division_.divide(states_.size(), [&](const Share& share, std::size_t) {
      const auto [first, last] = share;
      std::ranges::for_each(std::span(states_).subspan(first, last - first), settled);
    });
  }
  movers_.clear();
  clear_for(unsure_, body_count_);
  free_.insert(free_.end(), removed_.begin(), removed_.end());
  removed_.clear();
}

/// Drops the pairs whose boxes overlap no longer. None touches: each was collided in this step, or
/// proven apart. From the end: the last pair of a row takes a dropped one's place.
void Scene::drop_parted() {
  for (std::size_t k = pair_works_.size(); k-- > 0;) {
    std::vector<Parted>& parted = pair_works_[k].parted;
    for (std::size_t i = parted.size(); i-- > 0;) {
      drop(parted[i].a, candidates_.at(parted[i].place));
    }
    clear_for(parted, body_count_);
  }
}

/// In places of those that ended in this step, then behind the last of all.
void Scene::begin_contacts() {
  std::array<std::size_t, 2 * kTasks + 1> begun{};  // before those of a work
  for (std::size_t k = 0; k < pair_works_.size(); ++k) {
    begun[k + 1] = begun[k] + pair_works_[k].beginning.size();
  }
  const std::size_t count = begun[pair_works_.size()];
  // In the first places, where some stay vacant: the last contact of all has then not begun.
  if (vacant_.size() > count) std::ranges::sort(vacant_);
  const std::size_t behind_last = contacts_.size() - vacant_.size();
  resize(contacts_, std::max(contacts_.size(), behind_last + count));
  if (settings_.recycled_motion > 0) resize(kept_, contacts_.size());
  resize(began_, count);
  for_each_pair_work(count, [&](std::size_t k) {
    begin_contacts(pair_works_[k].beginning, begun[k], behind_last);
  });
  for (PairWork& work : pair_works_) clear_for(work.beginning, body_count_);
  // From the end: the last contact of all has then not ended, nor begun, so its pair is in a row.
  for (std::size_t i = vacant_.size(); i-- > count;) erase_contact(vacant_[i]);
  clear_for(vacant_, body_count_);
}

/// Begins those behind the first so many that begin.
void Scene::begin_contacts(std::span<const Beginning> beginning, std::size_t begun,
                           std::size_t behind_last) {
  const auto place_of = [&](std::size_t k) {
    return k < vacant_.size() ? vacant_[k] : static_cast<std::uint32_t>(behind_last + k);
  };
  for (std::size_t i = 0; i < beginning.size(); ++i, ++begun) {
    const std::size_t ahead = ahead_of(i, kContactsAhead, beginning.size());
    __builtin_prefetch(beginning[ahead].candidate);
    ask_for(contacts_, place_of(begun + ahead - i));
    const auto& [bodies, candidate, manifold] = beginning[i];
    const std::uint32_t contact = place_of(begun);
    candidate->touch(contact);
    began_[begun] = contact;
    contacts_[contact] = {handle(bodies.a), handle(bodies.b), manifold};
    if (is_sensed(bodies)) contacts_[contact].manifold.count = 0;
    if (settings_.recycled_motion > 0) kept_[contact] = {b_in_a(bodies), manifold};
  }
}

StepResult Scene::result() {
  PairCounts& pairs = counts_.pairs;
  pairs.at_rest = pairs.candidates - pairs.separated - pairs.recycled - pairs.collided;
  ended_reported_ = std::ssize(ended_);
  renumbered_reported_ = std::ssize(renumbered_);
  const std::size_t stayed = contacts_.size() - began_.size();
  return {contacts_, began_, renumbered_, ended_, stayed, std::exchange(counts_, {})};
}

}  // namespace manifuzz::scene
