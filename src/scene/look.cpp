#include <algorithm>
#include <utility>

#include "scene/recycled.hpp"
#include "scene/scene.hpp"

// The candidates of a step: which are looked at, and by whom.

namespace manifuzz::scene {
namespace {

/// Pairs that are collided together: enough for the kernel to sort, few enough for the cache.
constexpr std::size_t kQueueMax = 4096;

}  // namespace

/// In tasks, where there is an executor, each of which goes through its share of the rows. Contacts
/// to be recycled, and the few pairs of few bodies, are looked at here. New pairs come first, while
/// what they need is in the caches; where there are tasks they come last, since one files those
/// that left while others go through rows.
void Scene::look_at_candidates() {
  counts_.pairs.candidates = candidates_.size();
  const bool is_strict = settings_.recycled_motion == 0;
  if (few_moved_) division_.forget_executor();
  const std::size_t works = 2 * division_.row_tasks();
  if (pair_works_.size() < works) pair_works_.resize(works);
  const bool divides_rows = division_.has_executor() && is_strict;
  if (!divides_rows) {
    refile();
    find_all_partners();
    division_.forget_executor();
  }
  if (few_moved_) {
    look_at_movers();
  } else {
    if (is_strict) mark_bodies();
    look_at_all_rows();
  }
  if (divides_rows) find_all_partners();
  take_results();
}

/// All rows of the bodies that moved, and their pairs in the rows of others.
void Scene::look_at_movers() {
  division_.divide_with_scratch(1, 1, [&](const Share&, std::size_t, Scratch& scratch) {
    PairWork& work = begun_work(0, scratch, candidates_.all(), candidates_.size());
    for (const std::uint32_t body : movers_) {
      for (Candidate& candidate : candidates_.row(body)) look_at(body, candidate, work);
      look_at_partners(body, work);
    }
    collide_waiting(work);
  });
}

void Scene::look_at_all_rows() {
  const std::size_t tasks = division_.row_tasks();
  const auto look = [&](const Share& share, std::size_t task, Scratch& scratch) {
    if (tasks > 1 && task == 0) refile();
    PairWork& work = begun_work(task, scratch, candidates_.all(), candidates_.size());
    work.are_read = tasks > 1;
    look_at_rows(static_cast<std::uint32_t>(share.first), static_cast<std::uint32_t>(share.last),
                 work);
  };
  division_.divide_with_scratch(candidates_.rows(), tasks, look);
}

/// A work whose pairs wait in this scratch, and have their places among these candidates.
PairWork& Scene::begun_work(std::size_t work, Scratch& scratch, Candidate* candidates,
                            std::size_t count) {
  PairWork& begun = pair_works_[work];
  begun.scratch = &scratch;
  begun.candidates = candidates;
  begun.are_read = false;
  const std::size_t room = std::min(kQueueMax, count);
  for (Queue* const queue : {&scratch.touching, &scratch.apart}) queue->make_room_for(room);
  // A task that ran out of memory may have left some.
  scratch.touching.count = scratch.apart.count = scratch.leaving.count = 0;
  if (scratch.manifolds.size() < room) resize(scratch.manifolds, room);
  return begun;
}

void Scene::mark_bodies() {
  resize(marks_, states_.size());
  division_.divide(marks_.size(), [&](const Share& share, std::size_t) {
    for (std::size_t body = share.first; body < share.last; ++body) {
      marks_[body] = mark_of(paths_[body], states_[body]);
    }
  });
}

/// Pairs whose boxes overlap no longer are looked at a last time: `drop_parted` drops them.
void Scene::look_at_rows(std::uint32_t first, std::uint32_t last, PairWork& work) {
  // One at least: what is not pushed is written, too.
  const std::size_t leaving = left_.empty() ? 0 : candidates_.size_of(first, last);
  work.scratch->leaving.make_room_for(std::max<std::size_t>(leaving, 1));
  if (settings_.recycled_motion > 0) {
    for (std::uint32_t a = first; a < last; ++a) {
      candidates_.prefetch(a + kRowsAhead);
      look_at_row(a, work);
    }
  } else {
    Scratch& scratch = *work.scratch;
    SortedPairs sorted{scratch.touching, scratch.apart, scratch.leaving, !left_.empty()};
    for (std::uint32_t a = first; a < last;) {
      const std::uint32_t next = sort_rows(candidates_.all_rows(), marks_.data(), a, last, sorted);
      if (next == a) look_at_row(a, work);  // longer than the queues
      a = std::max(next, a + 1);
      collide_waiting(work);
    }
    work.pairs.separated += sorted.separated;
  }
  collide_waiting(work);
  note_parted(work);
}

/// Looks at a row's pairs one by one.
void Scene::look_at_row(std::uint32_t a, PairWork& work) {
  for (Candidate& candidate : candidates_.row(a)) {
    look_at(a, candidate, work);
    const bool has_left = is(a, kLeft) || is(candidate.b, kLeft);
    work.scratch->leaving.push({a, candidate.b}, candidates_.place_of(candidate), has_left);
  }
}

/// Pairs of which a body left its box, and whose boxes overlap no longer.
void Scene::note_parted(PairWork& work) const {
  Queue& leaving = work.scratch->leaving;
  const std::size_t count = std::exchange(leaving.count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    ask_for(boxes_, leaving.b[i + kPairLanes]);
    const kernel::BodyPair bodies = leaving.bodies(i);
    leaving.push(bodies, leaving.at[i], !overlap(bodies.a, bodies.b));
  }
  const std::size_t parted = std::exchange(leaving.count, 0);
  for (std::size_t i = 0; i < parted; ++i) work.parted.push_back({leaving.a[i], leaving.at[i]});
}

/// A body's pairs in other rows that are not looked at with these rows.
void Scene::look_at_partners(std::uint32_t body, PairWork& work) {
  for (const std::uint32_t other : cells_.near(boxes_[body])) {
    if (other > body || is(other, kMoved)) continue;
    Candidate* const candidate = candidates_.find(other, body);
    if (candidate == nullptr) continue;
    look_at(other, *candidate, work);
  }
}

void Scene::look_at(std::uint32_t a, Candidate& candidate, PairWork& work) {
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
  if (work.scratch->touching.count == work.scratch->touching.room()) collide_touching(work);
  if (work.scratch->apart.count == work.scratch->apart.room()) collide_apart(work);
  if (touches) {
    work.scratch->touching.push({a, b}, candidate.contact());
  } else {
    work.scratch->apart.push({a, b}, candidates_.place_of(candidate));
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

/// What came of the candidates, in their order; the last proof of a pair holds.
void Scene::take_results() {
  compared_ = 0;
  for_each_pair_work(candidates_.size(), [&](std::size_t k) {
    for (const auto& [place, known] : pair_works_[k].proofs) {
      candidates_.at(place).know(known);
    }
  });
  for (PairWork& work : pair_works_) {
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
