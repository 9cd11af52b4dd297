#include <algorithm>
#include <utility>

#include "scene/recycled.hpp"
#include "scene/scene.hpp"

// The candidates of a step: which are looked at, and by whom.

namespace manifuzz::scene {
namespace {

/// Pairs that are collided together: enough for the kernel to sort, few enough for the cache; and
/// where tasks have queues each, few enough for all of them.
constexpr std::size_t kQueueMax = 4096;
constexpr std::size_t kQueueMaxOfTask = 2048;

}  // namespace

/// In tasks, where there is an executor, each of which goes through its share of the rows. Contacts
/// to be recycled, and the few pairs of few bodies, are looked at here.
void Scene::look_at_candidates() {
  counts_.pairs.candidates = candidates_.size();
  const bool is_strict = settings_.recycled_motion == 0;
  const bool is_divided = executor_ != nullptr && !few_moved_ && is_strict;
  if (!is_divided) executor_ = nullptr;
  prepare_works(is_divided ? kTasks : 1);
  const std::uint32_t rows = candidates_.rows();
  RowWork& all = row_works_.front();
  if (few_moved_) {
    for (const std::uint32_t body : movers_) {
      for (Candidate& candidate : candidates_.row(body)) look_at(body, candidate, all);
      look_at_partners(body, all);
    }
    collide_waiting(all);
  } else if (!is_divided) {
    if (is_strict) mark_bodies();
    look_at_rows(0, rows, all);
  } else {
    mark_bodies();
    divide(rows, kTasks, [&](const Share& share, std::size_t task) {
      look_at_rows(static_cast<std::uint32_t>(share.first), static_cast<std::uint32_t>(share.last),
                   row_works_[task]);
    });
  }
  take_results();
}

void Scene::prepare_works(std::size_t count) {
  if (row_works_.size() < count) row_works_.resize(count);
  const std::size_t room = std::min(count == 1 ? kQueueMax : kQueueMaxOfTask, candidates_.size());
  for (RowWork& work : std::span(row_works_).first(count)) {
    for (Queue* const queue : {&work.touching, &work.apart}) queue->make_room_for(room);
    if (work.manifolds.size() < room) resize(work.manifolds, room);
  }
}

void Scene::mark_bodies() {
  resize(marks_, states_.size());
  divide(marks_.size(), tasks_for(marks_.size()), [&](const Share& share, std::size_t) {
    for (std::size_t body = share.first; body < share.last; ++body) {
      marks_[body] = mark_of(paths_[body], states_[body]);
    }
  });
}

/// Pairs whose boxes overlap no longer are looked at a last time: `drop_parted` drops them.
void Scene::look_at_rows(std::uint32_t first, std::uint32_t last, RowWork& work) {
  // One at least: what is not pushed is written, too.
  const std::size_t leaving = left_.empty() ? 0 : candidates_.size_of(first, last);
  work.leaving.make_room_for(std::max<std::size_t>(leaving, 1));
  if (settings_.recycled_motion > 0) {
    for (std::uint32_t a = first; a < last; ++a) {
      candidates_.prefetch(a + kRowsAhead);
      look_at_row(a, work);
    }
  } else {
    SortedPairs sorted{work.touching, work.apart, work.leaving, !left_.empty()};
    for (std::uint32_t a = first; a < last;) {
      const std::uint32_t next = sort_rows(candidates_.all_rows(), marks_.data(), a, last, sorted);
      if (next == a) look_at_row(a, work);  // longer than the queues
      a = std::max(next, a + 1);
      collide_waiting(work);
    }
    work.pairs.separated += sorted.separated;
  }
  collide_waiting(work);
  leave_out_overlapping(work.leaving);
}

/// Looks at a row's pairs one by one.
void Scene::look_at_row(std::uint32_t a, RowWork& work) {
  for (Candidate& candidate : candidates_.row(a)) {
    look_at(a, candidate, work);
    const bool has_left = is(a, kLeft) || is(candidate.b, kLeft);
    work.leaving.push({a, candidate.b}, candidates_.place_of(candidate), has_left);
  }
}

/// What is left are pairs whose boxes overlap no longer.
void Scene::leave_out_overlapping(Queue& leaving) const {
  const std::size_t count = std::exchange(leaving.count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    ask_for(boxes_, leaving.b[i + kPairLanes]);
    const kernel::BodyPair bodies = leaving.bodies(i);
    leaving.push(bodies, leaving.at[i], !overlap(bodies.a, bodies.b));
  }
}

/// A body's pairs in other rows that are not looked at with these rows.
void Scene::look_at_partners(std::uint32_t body, RowWork& work) {
  for (const std::uint32_t other : cells_.near(boxes_[body])) {
    if (other > body || is(other, kMoved)) continue;
    Candidate* const candidate = candidates_.find(other, body);
    if (candidate == nullptr) continue;
    look_at(other, *candidate, work);
  }
}

void Scene::look_at(std::uint32_t a, Candidate& candidate, RowWork& work) {
  const std::uint32_t b = candidate.b;
  const int states = states_[a] | states_[b];
  if ((states & kMoved) == 0) return;
  const bool touches = candidate.touches();
  const bool may_recycle = touches && (states & kUnproven) == 0 && overlap(a, b);
  if (may_recycle && recycle(a, candidate)) {
    ++work.pairs.recycled;
    return;
  }
  if (candidate.is_apart(paths_of(a, b))) {
    ++work.pairs.separated;
    return;
  }
  if (work.touching.count == work.touching.room()) collide_touching(work);
  if (work.apart.count == work.apart.room()) collide_apart(work);
  if (touches) {
    work.touching.push({a, b}, candidate.contact());
  } else {
    work.apart.push({a, b}, candidates_.place_of(candidate));
  }
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
  return true;
}

/// What came of the rows, in their order; the last proof of a pair holds.
void Scene::take_results() {
  compared_ = 0;
  for_each_row_work(candidates_.size(), [&](std::size_t k) {
    for (const auto& [place, known] : row_works_[k].proofs) {
      candidates_.at(place).know(known);
    }
  });
  for (RowWork& work : row_works_) {
    ended_.insert(ended_.end(), work.ended.begin(), work.ended.end());
    vacant_.insert(vacant_.end(), work.vacant.begin(), work.vacant.end());
    clear_for(work.proofs, candidates_.size());
    clear_for(work.ended, body_count_);
    clear_for(work.vacant, body_count_);
    const PairCounts pairs = std::exchange(work.pairs, {});
    counts_.pairs.separated += pairs.separated;
    counts_.pairs.recycled += pairs.recycled;
    counts_.pairs.collided += pairs.collided;
    counts_.proofs += std::exchange(work.proof_count, 0);
    compared_ += std::exchange(work.compared, 0);
  }
}

}  // namespace manifuzz::scene
