#include <algorithm>
#include <utility>

#include "kernel/pair_stream.hpp"
#include "scene/recycled.hpp"
#include "scene/scene.hpp"

namespace manifuzz::scene {
namespace {

/// Pairs that are collided together: enough for the kernel to sort, few enough for the cache.
constexpr std::size_t kQueueMax = 4096;

/// So many pairs ahead, contacts are asked for, and so many bodies ahead their rows: they lie
/// anywhere in memory.
constexpr std::size_t kAhead = 16;

}  // namespace

std::variant<StepResult, RefusedMove> Scene::step(std::span<const Move> moves) {
  for (std::size_t i = 0; i < moves.size(); ++i) {
    if (!is_known(moves[i].body)) return RefusedMove{i, Defect::unknown_body};
    if (const auto defect = find_defect(moves[i].pose)) return RefusedMove{i, *defect};
  }
  began_.clear();
  ended_.erase(ended_.begin(), ended_.begin() + std::exchange(ended_reported_, 0));
  for (const Move& move : moves) place(move);
  find_candidates();
  look_at_candidates();
  begin_contacts();
  for (const Mover& mover : movers_) {
    states_[mover.body] =
        static_cast<std::uint8_t>(states_[mover.body] & (kFiled | kAlone | kBoxed));
  }
  movers_.clear();
  return result();
}

void Scene::look_at_candidates() {
  const std::size_t room = std::min(kQueueMax, candidates_.size() + 2);
  for (Queue* const queue : {&touching_, &apart_}) {
    if (queue->pairs.size() < room) resize(queue->pairs, room);
  }
  if (manifolds_.size() < room) resize(manifolds_, room);
  if (few_moved_) {
    for (const Mover& mover : movers_) {
      prune_row(mover.body);
      for (Candidate& candidate : candidates_.row(mover.body)) look_at(mover.body, candidate);
      look_at_partners(mover.body);
    }
  } else {
    look_at_all_rows();
  }
  collide(touching_);
  collide_apart();
}

/// Drops the pairs whose boxes overlap no longer, and proofs that do not hold. From the end, where
/// the last contacts are: the last contact of all takes an ended one's place, and is looked for.
void Scene::prune_row(std::uint32_t a) {
  const std::span<Candidate> row = candidates_.row(a);
  std::size_t kept = row.size();
  for (std::size_t i = row.size(); i-- > 0;) {
    Candidate& candidate = row[i];
    const int states = states_[a] | states_[candidate.b];
    if ((states & kLeft) != 0 && !overlap(a, candidate.b)) {
      if (candidate.touches()) end_contact(candidate);
      ++counts_.pairs_dropped;
      candidate = row[--kept];
      continue;
    }
    if ((states & kUnproven) != 0 && !candidate.touches()) candidate.be_apart_until(0);
  }
  candidates_.keep(a, kept);
}

/// All rows: without branches that depend on a pair, where nothing is recycled.
void Scene::look_at_all_rows() {
  const std::uint8_t* const states = states_.data();
  const float* const paths = paths_.data();
  for (std::uint32_t a = 0; a < candidates_.rows(); ++a) {
    candidates_.prefetch(a + kAhead);
    if (!left_.empty()) {
      int of_row = states[a];
      for (const Candidate& candidate : candidates_.row(a)) of_row |= states[candidate.b];
      if ((of_row & kLeft) != 0) prune_row(a);
    }
    const std::span<Candidate> row = candidates_.row(a);
    if (settings_.recycled_motion > 0 || row.size() >= kQueueMax) {
      for (Candidate& candidate : row) look_at(a, candidate);
      continue;
    }
    if (!touching_.has_room(row.size())) collide(touching_);
    if (!apart_.has_room(row.size())) collide_apart();
    const int states_a = states[a];
    const float path_a = paths[a];
    Waiting* const touching = touching_.pairs.data();
    Waiting* const apart = apart_.pairs.data();
    std::size_t touching_count = touching_.count;
    std::size_t apart_count = apart_.count;
    std::size_t separated = 0;
    std::uint32_t place = row.empty() ? 0 : candidates_.place_of(row.front());
    for (const Candidate& candidate : row) {
      const std::uint32_t b = candidate.b;
      const bool moved = ((states_a | states[b]) & kMoved) != 0;
      const bool touches = candidate.touches();
      const bool is_apart = candidate.is_apart(path_a + paths[b]);
      touching[touching_count] = {a, place};
      touching_count += static_cast<std::size_t>(moved & touches);
      apart[apart_count] = {a, place++};
      apart_count += static_cast<std::size_t>(moved & !touches & !is_apart);
      separated += static_cast<std::size_t>(moved & is_apart);
    }
    touching_.count = touching_count;
    apart_.count = apart_count;
    counts_.pairs.separated += separated;
  }
}

/// Of a body, the pairs in other rows that are not looked at with those.
void Scene::look_at_partners(std::uint32_t body) {
  cells_.near(boxes_[body], found_);
  for (const std::uint32_t other : found_) {
    if (other > body || is(other, kMoved)) continue;
    Candidate* const candidate = candidates_.find(other, body);
    if (candidate == nullptr) continue;
    if (is(body, kUnproven) && !candidate->touches()) candidate->be_apart_until(0);
    look_at(other, *candidate);
  }
}

void Scene::look_at(std::uint32_t a, Candidate& candidate) {
  const std::uint32_t b = candidate.b;
  const int states = states_[a] | states_[b];
  if ((states & kMoved) == 0) return;
  const bool touches = candidate.touches();
  if (touches && (states & kUnproven) == 0 && recycle(a, candidate)) return;
  const bool is_apart = candidate.is_apart(paths_[a] + paths_[b]);
  if (!touching_.has_room(1)) collide(touching_);
  if (!apart_.has_room(1)) collide_apart();
  if (is_apart) {
    ++counts_.pairs.separated;
    return;
  }
  Queue& queue = touches ? touching_ : apart_;
  queue.pairs[queue.count++] = {a, candidates_.place_of(candidate)};
}

void Scene::collide_apart() {
  leave_out_apart();
  collide(apart_);
}

/// Of the pairs that wait and did not touch, those whose tight boxes do not overlap.
void Scene::leave_out_apart() {
  if (!settings_.certificates) return;
  std::size_t undrawn = 0;
  resize(bodies_, std::min(2 * apart_.count, states_.size()) + 1);
  for (const Waiting& pair : std::span(apart_.pairs).first(apart_.count)) {
    const auto [a, b] = bodies_of(pair);
    for (const std::uint32_t body : {a, b}) {
      bodies_[undrawn] = body;
      undrawn += static_cast<std::size_t>(!is(body, kBoxed));
      states_[body] |= kBoxed;
    }
  }
  bodies_.resize(undrawn);
  draw_tight_boxes();
  std::size_t kept = 0;
  for (const Waiting& pair : std::span(apart_.pairs).first(apart_.count)) {
    const kernel::BodyPair bodies = bodies_of(pair);
    const float apart = gap(tight_[bodies.a], tight_[bodies.b]);
    if (apart > 0) {
      prove_apart(bodies, apart, candidates_.at(pair.place));
      ++counts_.pairs.separated;
      continue;
    }
    apart_.pairs[kept++] = pair;
  }
  apart_.count = kept;
}

/// Manifolds of pairs that touched go straight to their contacts.
void Scene::collide(Queue& queue) {
  kernel::PairStream<float> stream(shapes_.for_pairs(), placements_, settings_.tie_bias);
  for (std::size_t i = 0; i < queue.count; ++i) {
    const Candidate& soon =
        candidates_.at(queue.pairs[std::min(i + kAhead, queue.count - 1)].place);
    if (soon.touches()) __builtin_prefetch(&contacts_[soon.contact()]);
    const Candidate& candidate = candidates_.at(queue.pairs[i].place);
    stream.push(bodies_of(queue.pairs[i]),
                candidate.touches() ? contacts_[candidate.contact()].manifold : manifolds_[i]);
  }
  stream.finish();
  for (std::size_t i = queue.count; i-- > 0;) {
    Candidate& candidate = candidates_.at(queue.pairs[i].place);
    const kernel::BodyPair bodies = bodies_of(queue.pairs[i]);
    if (candidate.touches()) {
      conclude_touching(bodies, candidate, contacts_[candidate.contact()].manifold);
    } else {
      conclude(bodies, candidate, manifolds_[i]);
    }
  }
  counts_.pairs.collided += queue.count;
  queue.count = 0;
}

void Scene::conclude_touching(const kernel::BodyPair& bodies, Candidate& candidate,
                              const Manifold<float>& manifold) {
  if (manifold.count > 0) {
    if (settings_.recycled_motion > 0) kept_[candidate.contact()] = {b_in_a(bodies), manifold};
    return;
  }
  const float gap = -manifold.points[0].depth;
  end_contact(candidate);
  prove_apart(bodies, margin_of(bodies, gap), candidate);
}

/// Contacts begin at the end of the step: until then those that end leave no gaps in what began.
void Scene::conclude(const kernel::BodyPair& bodies, Candidate& candidate,
                     const Manifold<float>& manifold) {
  if (manifold.count > 0) {
    beginning_.push_back({bodies, &candidate, manifold});
    return;
  }
  prove_apart(bodies, margin_of(bodies, -manifold.points[0].depth), candidate);
}

/// What a gap between two polygons, as the kernel found it, proves (certificates.md); lengths.
float Scene::margin_of(const kernel::BodyPair& bodies, float gap) const {
  const ShapeFacts& a = facts(bodies.a);
  const ShapeFacts& b = facts(bodies.b);
  const float extent =
      a.reach + b.reach + a.radius + b.radius +
      length_at_most(placements_[bodies.b].pose.position - placements_[bodies.a].pose.position);
  const float padding = a.padding + b.padding - (a.radius + b.radius);
  return kRoundDown * gap - kSeparationError * extent - 1.001F * padding;
}

void Scene::prove_apart(const kernel::BodyPair& bodies, float margin, Candidate& candidate) {
  candidate.be_apart_until(0);
  if (!settings_.certificates || !(margin > 0)) return;
  candidate.be_apart_until((paths_[bodies.a] + paths_[bodies.b] + margin) * (1 - 8 * kRoundoff));
  ++counts_.proofs;
}

void Scene::begin_contacts() {
  for (const auto& [bodies, candidate, manifold] : beginning_) {
    const auto contact = static_cast<std::uint32_t>(contacts_.size());
    candidate->touch(contact);
    began_.push_back(contact);
    make_room(contacts_, contacts_.size() + 1);
    contacts_.push_back({handle(bodies.a), handle(bodies.b), manifold});
    if (settings_.recycled_motion > 0) kept_.push_back({b_in_a(bodies), manifold});
  }
  beginning_.clear();
  if (beginning_.capacity() > kQueueMax)
    beginning_ = std::vector<Beginning>();  // a first step's are no measure
}

/// From what the kernel gave, whenever that was: nothing accumulates.
bool Scene::recycle(std::uint32_t a, const Candidate& candidate) {
  if (settings_.recycled_motion == 0) return false;
  const Kept& kept = kept_[candidate.contact()];
  const Pose<float> now = b_in_a({a, candidate.b});
  if (!(displacement(kept.b_in_a, now, facts(candidate.b).reach) < settings_.recycled_motion)) {
    return false;
  }
  contacts_[candidate.contact()].manifold = recycled(kept.manifold, kept.b_in_a, now);
  ++counts_.pairs.recycled;
  return true;
}

StepResult Scene::result() {
  PairCounts& pairs = counts_.pairs;
  pairs.candidates = candidates_.size();
  pairs.at_rest = pairs.candidates - pairs.separated - pairs.recycled - pairs.collided;
  ended_reported_ = std::ssize(ended_);
  const std::size_t stayed = contacts_.size() - began_.size();
  return {contacts_, began_, ended_, stayed, std::exchange(counts_, {})};
}

}  // namespace manifuzz::scene
