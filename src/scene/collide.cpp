#include <algorithm>
#include <utility>

#include "kernel/pair_stream.hpp"
#include "scene/scene.hpp"

// The pairs that wait: boxes again, collide, and what that proves.

namespace manifuzz::scene {
namespace {

/// A number, or 0; by its bits, since a compiler makes a branch of `?:`.
float float_if(bool is_chosen, float number) {
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(number) &
                              (0 - static_cast<std::uint32_t>(is_chosen)));
}

}  // namespace

/// Tight boxes that the pairs apart ask for and that are not drawn.
void Scene::draw_undrawn(RowWork& work) {
  const Queue& apart = work.apart;
  std::vector<std::uint32_t>& undrawn = work.undrawn;
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
/// depends on whether they do: a pair of which nothing is proven is given the proof 0.
void Scene::leave_out_apart(RowWork& work) {
  if (!settings_.certificates) return;
  if (!all_are_boxed_) draw_undrawn(work);
  Queue& apart = work.apart;
  const std::size_t count = std::exchange(apart.count, 0);
  const Box* const tight = tight_.data();
  for (std::size_t i = 0; i < count; ++i) {
    ask_for(tight_, apart.b[i + kPairLanes]);
    const kernel::BodyPair bodies = apart.bodies(i);
    const std::uint32_t place = apart.at[i];
    const float room = gap(tight[bodies.a], tight[bodies.b]);
    const bool is_apart = room > 0;
    write_proof(place, float_if(is_apart, paths_to(bodies, room)), work);
    apart.push(bodies, place, !is_apart);
  }
  work.compared += count;
  work.pairs.separated += count - apart.count;
  work.proof_count += count - apart.count;
}

/// Each pair's manifold goes where `out` says of its place in the queue.
template <class Out>
void Scene::collide(const Queue& queue, Out out, RowWork& work) {
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

void Scene::collide_waiting(RowWork& work) {
  collide_touching(work);
  collide_apart(work);
}

/// Manifolds of pairs that touched go straight to their contacts. The places of those that end are
/// vacant until contacts begin.
void Scene::collide_touching(RowWork& work) {
  Queue& queue = work.touching;
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
    prove_apart(bodies, -contact.manifold.points[0].depth, place, work);
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
void Scene::collide_apart(RowWork& work) {
  leave_out_apart(work);
  Queue& apart = work.apart;
  const std::span manifolds(work.manifolds);
  const auto out = [manifolds](std::size_t i) -> Manifold<float>& { return manifolds[i]; };
  collide(apart, out, work);
  for (std::size_t i = 0; i < apart.count; ++i) {
    const kernel::BodyPair bodies = apart.bodies(i);
    if (manifolds[i].count > 0) {
      work.beginning.push_back({bodies, &candidates_.at(apart.at[i]), manifolds[i]});
    } else {
      prove_apart(bodies, -manifolds[i].points[0].depth, apart.at[i], work);
    }
  }
  apart.count = 0;
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

void Scene::prove_apart(const kernel::BodyPair& bodies, float gap, std::uint32_t place,
                        RowWork& work) {
  const float margin = margin_of(bodies, gap);
  const bool is_proven = settings_.certificates && margin > 0;
  write_proof(place, is_proven ? paths_to(bodies, margin) : 0, work);
  work.proof_count += static_cast<std::size_t>(is_proven);
}

/// Writes what is proven now, or once all tasks have ended.
void Scene::write_proof(std::uint32_t place, float until, RowWork& work) {
  if (executor_ == nullptr) {
    candidates_.at(place).be_apart_until(until);
  } else {
    work.proofs.push_back({place, until});
  }
}

}  // namespace manifuzz::scene
