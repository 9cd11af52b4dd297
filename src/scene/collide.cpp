#include <algorithm>
#include <utility>

#include "kernel/pair_stream.hpp"
#include "scene/faces.hpp"
#include "scene/scene.hpp"

// The pairs that wait: boxes again, collide, and what that proves.

namespace manifuzz::scene {
namespace {

/// One number or another; by their bits, since a compiler makes a branch of `?:`.
std::uint32_t chosen(bool is_first, std::uint32_t first, std::uint32_t second) {
  return second ^ ((first ^ second) & (0 - static_cast<std::uint32_t>(is_first)));
}

}  // namespace

/// Tight boxes that the pairs apart ask for and that are not drawn.
void Scene::draw_undrawn(PairWork& work) {
  const Queue& apart = work.scratch->apart;
  std::vector<std::uint32_t>& undrawn = work.scratch->undrawn;
  resize(undrawn, std::min(2 * apart.count, states_.size()) + 1);
  std::size_t count = 0;
  for (std::size_t i = 0; i < apart.count; ++i) {
    for (const std::uint32_t body : {apart.a[i], apart.b[i]}) {
      undrawn[count] = body;
      count += static_cast<std::size_t>(!is(body, kBoxed));
      states_[body] |= kBoxed;
    }
  }
  draw_tight_boxes(std::span<const std::uint32_t>(undrawn).first(count));
}

/// Leaves out pairs that wait and did not touch, where their tight boxes do not overlap. No branch
/// depends on whether they do: what is known of other pairs is written again.
void Scene::leave_out_apart(PairWork& work) {
  if (!settings_.certificates) return;
  if (!all_are_boxed_) draw_undrawn(work);
  Queue& apart = work.scratch->apart;
  const std::size_t count = std::exchange(apart.count, 0);
  const Box* const tight = tight_.data();
  for (std::size_t i = 0; i < count; ++i) {
    ask_for(tight_, apart.b[i + kPairLanes]);
    const kernel::BodyPair bodies = apart.bodies(i);
    const std::uint32_t place = apart.at[i];
    const float room = gap(tight[bodies.a], tight[bodies.b]);
    const bool is_apart = room > 0;
    const std::uint32_t known = work.candidates[place].known();
    const std::uint32_t apart_now = apart_until(paths_to(bodies, room), FaceBetween(known));
    work.know(place, chosen(is_apart, apart_now, known));
    apart.push(bodies, place, !is_apart);
  }
  work.compared += count;
  work.pairs.separated += count - apart.count;
  work.proof_count += count - apart.count;
}

/// Leaves out pairs between which the face that lay there last still lies, by more than what may
/// touch across it. Those of which no face is known stay.
void Scene::leave_out_behind_faces(PairWork& work) {
  if (!settings_.certificates || work.scratch->apart.count == 0) return;
  const FacedBodies bodies{&shapes_.for_pairs().corners(0),
                           &shapes_.rows(0),
                           &shapes_.facts(0),
                           placements_.data(),
                           paths_.data(),
                           work.candidates};
  std::array<std::uint32_t, 256> known;
  Queue& apart = work.scratch->apart;
  const std::size_t count = std::exchange(apart.count, 0);
  for (std::size_t first = 0; first < count; first += known.size()) {
    const std::size_t some = std::min(known.size(), count - first);
    prove_by_faces(bodies, apart, first, some, known.data());
    for (std::size_t i = 0; i < some; ++i) {
      const std::uint32_t place = apart.at[first + i];
      const bool is_apart = known[i] != 0;
      if (is_apart) work.know(place, known[i]);
      work.proof_count += static_cast<std::size_t>(known[i] > FaceBetween::kBits);
      apart.push(apart.bodies(first + i), place, !is_apart);
    }
  }
  work.pairs.separated += count - apart.count;
}

/// Each pair's manifold goes where `out` says of its place in the queue.
template <class Out>
void Scene::collide(const Queue& queue, Out out, PairWork& work) {
  if (queue.count == 0) return;
  kernel::PairStream<float> stream(shapes_.for_pairs(), placements_, settings_.tie_bias);
  const std::span a(queue.a);  // known not to change
  const std::span b(queue.b);
  const std::span placements(placements_);
  const std::size_t count = queue.count;
  for (std::size_t i = 0; i < count; ++i) {
    ask_for(placements, b[i + kPairLanes]);
    stream.push({a[i], b[i]}, out(i));
  }
  stream.finish();
  work.pairs.collided += queue.count;
}

void Scene::collide_waiting(PairWork& work) {
  collide_touching(work);
  collide_apart(work);
}

/// Manifolds of pairs that touched go straight to their contacts. The places of those that end are
/// vacant until contacts begin.
void Scene::collide_touching(PairWork& work) {
  Queue& queue = work.scratch->touching;
  const auto out = [contacts = std::span(contacts_),
                    at = std::span(queue.at)](std::size_t i) -> Manifold<float>& {
    ask_for(contacts, at[i + kPairLanes]);
    return contacts[at[i]].manifold;
  };
  collide(queue, out, work);
  if (settings_.recycled_motion > 0) keep_touching(queue);
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
    work.ended.push_back({contact.a, contact.b});
    work.vacant.push_back(queue.at[i]);
    const std::uint32_t place = candidates_.place_of(*candidates_.find(bodies.a, bodies.b));
    prove_apart(bodies, contact.manifold, place, work);
  }
  queue.count = 0;
}

/// What the kernel gave, to be carried along.
void Scene::keep_touching(const Queue& touching) {
  for (std::size_t i = 0; i < touching.count; ++i) {
    const std::uint32_t contact = touching.at[i];
    kept_[contact] = {b_in_a(touching.bodies(i)), contacts_[contact].manifold};
  }
}

/// Contacts begin at the end of the step, when it is known whose places are vacant.
void Scene::collide_apart(PairWork& work) {
  leave_out_apart(work);
  leave_out_behind_faces(work);
  Queue& apart = work.scratch->apart;
  const std::span manifolds(work.scratch->manifolds);
  const auto out = [manifolds](std::size_t i) -> Manifold<float>& { return manifolds[i]; };
  collide(apart, out, work);
  for (std::size_t i = 0; i < apart.count; ++i) {
    const kernel::BodyPair bodies = apart.bodies(i);
    if (manifolds[i].count > 0) {
      work.beginning.push_back({bodies, &work.candidates[apart.at[i]], manifolds[i]});
    } else {
      prove_apart(bodies, manifolds[i], apart.at[i], work);
    }
  }
  apart.count = 0;
}

/// Where the kernel finds two bodies to have no contact: what its gap proves (certificates.md).
void Scene::prove_apart(const kernel::BodyPair& bodies, const Manifold<float>& none,
                        std::uint32_t place, PairWork& work) {
  const auto& [position, depth, features] = none.points[0];
  const ShapeFacts& a = facts(bodies.a);
  const ShapeFacts& b = facts(bodies.b);
  const float separation = a.radius + b.radius - depth;
  const float distance =
      length_at_most(placements_[bodies.b].pose.position - placements_[bodies.a].pose.position);
  const float clearance = a.clearance + b.clearance;
  const float margin = kRoundDown * separation - kSeparationError * distance - clearance;
  const bool is_proven = settings_.certificates && margin > 0;
  const float until = is_proven ? paths_to(bodies, margin) : 0;
  work.know(place, apart_until(until, FaceBetween(features)));
  work.proof_count += static_cast<std::size_t>(is_proven);
}

}  // namespace manifuzz::scene
