#include <algorithm>
#include <utility>

#include "kernel/pair_stream.hpp"
#include "scene/recycled.hpp"
#include "scene/scene.hpp"

namespace manifuzz::scene {
namespace {

/// Pairs that are collided together: enough for the kernel to sort, few enough for the cache.
constexpr std::size_t kQueueMax = 4096;

/// So many pairs ahead, contacts and candidates are asked for: they lie anywhere in memory.
constexpr std::size_t kAhead = 16;

}  // namespace

std::variant<StepResult, RefusedMove> Scene::step(std::span<const Move> moves) {
  if (const auto refused = find_refused(moves)) return *refused;
  began_.clear();
  ended_.erase(ended_.begin(), ended_.begin() + std::exchange(ended_reported_, 0));
  renumbered_.erase(renumbered_.begin(),
                    renumbered_.begin() + std::exchange(renumbered_reported_, 0));
  place(moves_of_parts(moves));
  find_candidates();
  look_at_candidates();
  begin_contacts();
  drop_parted();
  settle();
  return result();
}

/// What happened to the bodies is over.
void Scene::settle() {
  const auto settled = [](std::uint8_t& state) {
    state = static_cast<std::uint8_t>(state & (kFiled | kAlone | kBoxed));
  };
  if (few_moved_) {
    for (const Mover& mover : movers_) settled(states_[mover.body]);
  } else {
    std::ranges::for_each(states_, settled);
  }
  movers_.clear();
  free_.insert(free_.end(), removed_.begin(), removed_.end());
  removed_.clear();
}

void Scene::look_at_candidates() {
  const std::size_t room = std::min(kQueueMax, candidates_.size() + kRowLanes + 2);
  for (Queue* const queue : {&touching_, &apart_}) queue->make_room_for(room);
  if (manifolds_.size() < room) resize(manifolds_, room);
  counts_.pairs.candidates = candidates_.size();
  if (few_moved_) {
    for (const Mover& mover : movers_) {
      for (Candidate& candidate : candidates_.row(mover.body)) look_at(mover.body, candidate);
      look_at_partners(mover.body);
    }
  } else {
    look_at_all_rows();
  }
  collide_touching();
  collide_apart();
}

/// Pairs whose boxes overlap no longer are looked at a last time: `drop_parted` drops them.
void Scene::look_at_all_rows() {
  leaving_.make_room_for((left_.empty() ? 0 : candidates_.size()) + kRowLanes + 1);
  if (settings_.recycled_motion > 0) {
    for (std::uint32_t a = 0; a < candidates_.rows(); ++a) {
      candidates_.prefetch(a + kRowsAhead);
      look_at_row(a);
    }
    return;
  }
  resize(marks_, states_.size());
  for (std::size_t body = 0; body < marks_.size(); ++body) {
    marks_[body] = mark_of(paths_[body], states_[body] & (kMoved | kLeft));
  }
  SortedPairs sorted{touching_, apart_, leaving_, !left_.empty()};
  for (std::uint32_t a = 0; a < candidates_.rows();) {
    const std::uint32_t next = sort_rows(candidates_, marks_.data(), a, sorted);
    if (next == a) look_at_row(a);  // longer than the queues
    a = std::max(next, a + 1);
    collide_touching();
    collide_apart();
  }
  counts_.pairs.separated += sorted.separated;
}

/// One by one.
void Scene::look_at_row(std::uint32_t a) {
  for (Candidate& candidate : candidates_.row(a)) {
    look_at(a, candidate);
    const bool has_left = is(a, kLeft) || is(candidate.b, kLeft);
    leaving_.push({a, candidate.b}, candidates_.place_of(candidate), has_left);
  }
}

/// Drops the pairs whose boxes overlap no longer. None touches: each was collided in this step, or
/// proven apart. From the end: the last pair of a row takes a dropped one's place.
void Scene::drop_parted() {
  Queue& queue = leaving_;
  const std::size_t count = std::exchange(queue.count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const kernel::BodyPair bodies = queue.bodies(i);
    queue.push(bodies, queue.at[i], !overlap(bodies.a, bodies.b));
  }
  for (std::size_t i = std::exchange(queue.count, 0); i-- > 0;) {
    drop(queue.a[i], candidates_.at(queue.at[i]));
  }
}

/// A body's pairs in other rows that are not looked at with these rows.
void Scene::look_at_partners(std::uint32_t body) {
  for (const std::uint32_t other : cells_.near(boxes_[body])) {
    if (other > body || is(other, kMoved)) continue;
    Candidate* const candidate = candidates_.find(other, body);
    if (candidate == nullptr) continue;
    look_at(other, *candidate);
  }
}

void Scene::look_at(std::uint32_t a, Candidate& candidate) {
  const std::uint32_t b = candidate.b;
  const int states = states_[a] | states_[b];
  if ((states & kMoved) == 0) return;
  const bool touches = candidate.touches();
  const bool may_recycle = touches && (states & kUnproven) == 0 && overlap(a, b);
  if (may_recycle && recycle(a, candidate)) return;
  if (candidate.is_apart(paths_[a] + paths_[b])) {
    ++counts_.pairs.separated;
    return;
  }
  if (!touching_.has_room(1)) collide_touching();
  if (!apart_.has_room(1)) collide_apart();
  if (touches) {
    touching_.push({a, b}, candidate.contact());
  } else {
    apart_.push({a, b}, candidates_.place_of(candidate));
  }
}

/// Leaves out pairs that wait and did not touch, where their tight boxes do not overlap.
void Scene::leave_out_apart() {
  if (!settings_.certificates) return;
  const std::size_t count = std::exchange(apart_.count, 0);
  std::size_t undrawn = 0;
  resize(bodies_, std::min(2 * count, states_.size()) + 1);
  for (std::size_t i = 0; i < count; ++i) {
    for (const std::uint32_t body : {apart_.a[i], apart_.b[i]}) {
      bodies_[undrawn] = body;
      undrawn += static_cast<std::size_t>(!is(body, kBoxed));
      states_[body] |= kBoxed;
    }
  }
  bodies_.resize(undrawn);
  draw_tight_boxes();
  for (std::size_t i = 0; i < count; ++i) {
    const kernel::BodyPair bodies = apart_.bodies(i);
    const float apart = gap(tight_[bodies.a], tight_[bodies.b]);
    candidates_.at(apart_.at[i]).be_apart_until(apart > 0 ? paths_to(bodies, apart) : 0);
    apart_.push(bodies, apart_.at[i], !(apart > 0));
  }
  counts_.pairs.separated += count - apart_.count;
  counts_.proofs += count - apart_.count;
}

/// Each pair's manifold goes where `out` says of its place in the queue.
template <class Out>
void Scene::collide(const Queue& queue, const Out& out) {
  kernel::PairStream<float> stream(shapes_.for_pairs(), placements_, settings_.tie_bias);
  for (std::size_t i = 0; i < queue.count; ++i) stream.push(queue.bodies(i), out(i));
  stream.finish();
  counts_.pairs.collided += queue.count;
}

/// Manifolds of pairs that touched go straight to their contacts. The places of those that end are
/// vacant until contacts begin.
void Scene::collide_touching() {
  Queue& queue = touching_;
  collide(queue, [&](std::size_t i) -> Manifold<float>& {
    __builtin_prefetch(&contacts_[queue.at[std::min(i + kAhead, queue.count - 1)]]);
    return contacts_[queue.at[i]].manifold;
  });
  if (settings_.recycled_motion > 0) keep_touching();
  const std::size_t count = std::exchange(queue.count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t contact = queue.at[i];
    const kernel::BodyPair bodies = queue.bodies(i);
    Manifold<float>& manifold = contacts_[contact].manifold;
    queue.push(bodies, contact, manifold.count == 0);
    if (is_sensed(bodies)) manifold.count = 0;
  }
  for (std::size_t i = 0; i < queue.count; ++i) {
    const kernel::BodyPair bodies = queue.bodies(i);
    const Contact& contact = contacts_[queue.at[i]];
    ended_.push_back({contact.a, contact.b});
    vacant_.push_back(queue.at[i]);
    prove_apart(bodies, -contact.manifold.points[0].depth, *candidates_.find(bodies.a, bodies.b));
  }
  queue.count = 0;
}

/// What the kernel gave, to be carried along.
void Scene::keep_touching() {
  for (std::size_t i = 0; i < touching_.count; ++i) {
    const std::uint32_t contact = touching_.at[i];
    kept_[contact] = {b_in_a(touching_.bodies(i)), contacts_[contact].manifold};
  }
}

/// Contacts begin at the end of the step, when it is known whose places are vacant.
void Scene::collide_apart() {
  leave_out_apart();
  collide(apart_, [&](std::size_t i) -> Manifold<float>& { return manifolds_[i]; });
  for (std::size_t i = 0; i < apart_.count; ++i) {
    const kernel::BodyPair bodies = apart_.bodies(i);
    Candidate& candidate = candidates_.at(apart_.at[i]);
    if (manifolds_[i].count > 0) {
      beginning_.push_back({bodies, &candidate, manifolds_[i]});
    } else {
      prove_apart(bodies, -manifolds_[i].points[0].depth, candidate);
    }
  }
  apart_.count = 0;
}

/// What a gap between two polygons, as the kernel found it, proves (certificates.md); lengths.
float Scene::margin_of(const kernel::BodyPair& bodies, float gap) const {
  const ShapeFacts& a = facts(bodies.a);
  const ShapeFacts& b = facts(bodies.b);
  const float extent =
      a.extent() + b.extent() +
      length_at_most(placements_[bodies.b].pose.position - placements_[bodies.a].pose.position);
  const float padding = a.padding + b.padding - (a.radius + b.radius);
  return kRoundDown * gap - kSeparationError * extent - 1.001F * padding;
}

void Scene::prove_apart(const kernel::BodyPair& bodies, float gap, Candidate& candidate) {
  const float margin = margin_of(bodies, gap);
  const bool is_proven = settings_.certificates && margin > 0;
  candidate.be_apart_until(is_proven ? paths_to(bodies, margin) : 0);
  counts_.proofs += static_cast<std::size_t>(is_proven);
}

/// In the first places of those that ended in this step, then behind the last of all.
void Scene::begin_contacts() {
  std::ranges::sort(vacant_);
  const std::size_t count = beginning_.size();
  const std::size_t behind_last = contacts_.size() - vacant_.size();
  resize(contacts_, std::max(contacts_.size(), behind_last + count));
  if (settings_.recycled_motion > 0) resize(kept_, contacts_.size());
  for (std::size_t i = 0; i < count; ++i) {
    __builtin_prefetch(beginning_[std::min(i + kAhead, count - 1)].candidate);
    const auto& [bodies, candidate, manifold] = beginning_[i];
    const std::uint32_t contact =
        i < vacant_.size() ? vacant_[i] : static_cast<std::uint32_t>(behind_last + i);
    candidate->touch(contact);
    began_.push_back(contact);
    contacts_[contact] = {handle(bodies.a), handle(bodies.b), manifold};
    if (is_sensed(bodies)) contacts_[contact].manifold.count = 0;
    if (settings_.recycled_motion > 0) kept_[contact] = {b_in_a(bodies), manifold};
  }
  // From the end: the last contact of all has then neither ended nor begun.
  for (std::size_t i = vacant_.size(); i-- > count;) erase_contact(vacant_[i]);
  clear_for(beginning_, body_count_);
  clear_for(vacant_, body_count_);
}

/// From what the kernel gave, whenever that was: nothing accumulates.
bool Scene::recycle(std::uint32_t a, const Candidate& candidate) {
  if (settings_.recycled_motion == 0) return false;
  const Kept& kept = kept_[candidate.contact()];
  const Pose<float> now = b_in_a({a, candidate.b});
  if (!(displacement(kept.b_in_a, now, facts(candidate.b).reach) < settings_.recycled_motion)) {
    return false;
  }
  Manifold<float>& manifold = contacts_[candidate.contact()].manifold;
  manifold = recycled(kept.manifold, kept.b_in_a, now);
  if (is_sensed({a, candidate.b})) manifold.count = 0;
  ++counts_.pairs.recycled;
  return true;
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
