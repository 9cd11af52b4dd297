#include <algorithm>
#include <map>

#include "geometry/pair_case.hpp"
#include "kernel/batch.hpp"
#include "measure/scene/scene_run.hpp"

namespace manifuzz {
namespace {

constexpr std::size_t kPairsMax = 60'000'000;
constexpr std::size_t kFindingsMax = 16;

using Bodies = std::pair<std::uint32_t, std::uint32_t>;

/// The contacts of all pairs of bodies where they are now, by the kernel that the scene uses: one
/// body against all behind it at a time, for all pairs would not fit into memory.
std::map<Bodies, Manifold<float>> contacts_of_all_pairs(
    const kernel::Shapes<float>& shapes, std::span<const kernel::Placement<float>> bodies,
    float tie_bias) {
  std::map<Bodies, Manifold<float>> contacts;
  std::vector<kernel::BodyPair> pairs;
  std::vector<Manifold<float>> manifolds;
  const auto count = static_cast<std::uint32_t>(bodies.size());
  for (std::uint32_t a = 0; a < count; ++a) {
    pairs.clear();
    for (std::uint32_t b = a + 1; b < count; ++b) pairs.push_back({a, b});
    manifolds.resize(pairs.size());
    kernel::collide_pairs(shapes, bodies, pairs, tie_bias, manifolds);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (manifolds[i].count > 0) contacts[{a, pairs[i].b}] = manifolds[i];
    }
  }
  return contacts;
}

Bodies bodies_of(const scene::Contact& contact) {
  return {contact.a.index, contact.b.index};
}

Bodies bodies_of(const scene::Touching& touching) {
  return {touching.bodies.a, touching.bodies.b};
}

/// Holds contacts against the right ones of these bodies.
template <class Contacts>
void compare(const Contacts& contacts, std::map<Bodies, Manifold<float>> right,
             std::span<const Body> where, AfreshCheck& check) {
  const auto note = [&](const Bodies& bodies) {
    ++check.mismatches;
    if (check.findings.size() == kFindingsMax) return;
    check.findings.push_back({where[bodies.first], where[bodies.second]});
  };
  for (const auto& contact : contacts) {
    const Bodies bodies = bodies_of(contact);
    const auto found = right.find(bodies);
    if (found == right.end() || !same_bits(found->second, contact.manifold)) note(bodies);
    if (found != right.end()) right.erase(found);
  }
  for (const auto& [bodies, manifold] : right) note(bodies);
}

}  // namespace

AfreshCheck check_afresh(const Trajectory& trajectory, const scene::Settings& settings) {
  AfreshCheck check;
  const std::size_t bodies = trajectory.start.size();
  const std::size_t steps = trajectory.steps.size() + 1;  // and as they start
  const std::size_t affordable = kPairsMax / std::max<std::size_t>(1, bodies * (bodies - 1) / 2);
  if (affordable == 0) return check;
  const std::size_t every = (steps + affordable - 1) / affordable;
  ScenePlayer player(trajectory, settings);
  AfreshPlayer afresh(trajectory, settings);
  kernel::Shapes<float> shapes;
  for (const auto& shape : trajectory.shapes) shapes.add(shape);
  auto placements = trajectory.start;
  std::vector<Body> where = trajectory.bodies();
  for (std::size_t step = 0; step < steps; ++step) {
    if (step > 0) {
      const auto& moves = trajectory.steps[step - 1];
      for (const BodyMove& move : moves) placements[move.body].pose = move.pose;
      move_bodies(moves, where);
      player.step(moves);
      afresh.step(moves);
    }
    const bool is_last_of_its_share = (steps - 1 - step) % every == 0;
    if (!is_last_of_its_share) continue;
    const auto right = contacts_of_all_pairs(shapes, placements, settings.tie_bias);
    compare(player.result().contacts, right, where, check);
    compare(afresh.step({}), right, where, check);
    ++check.steps;
  }
  return check;
}

}  // namespace manifuzz
