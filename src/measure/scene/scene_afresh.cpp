#include <algorithm>
#include <map>

#include "geometry/manifold.hpp"
#include "kernel/batch.hpp"
#include "measure/scene/scene_run.hpp"

namespace manifuzz {
namespace {

constexpr std::size_t kPairsMax = 60'000'000;
constexpr std::size_t kFindingsMax = 16;

/// All pairs of bodies where they are now, collided by the kernel that the scene uses.
class Afresh {
 public:
  Afresh(const Trajectory& trajectory, float tie_bias)
      : polygons_(trajectory.shapes), placements_(trajectory.start), tie_bias_(tie_bias) {
    for (const auto& shape : trajectory.shapes) shapes_.add(shape);
  }

  void move(std::span<const BodyMove> moves) {
    for (const BodyMove& move : moves) placements_[move.body].pose = move.pose;
  }

  void check(std::span<const scene::Contact> contacts, AfreshCheck& check) {
    ++check.steps;
    auto right = contacts_of_all_pairs();
    const auto note = [&](const Bodies& bodies) {
      ++check.mismatches;
      if (check.findings.size() < kFindingsMax) check.findings.push_back(pair(bodies));
    };
    for (const scene::Contact& contact : contacts) {
      const Bodies bodies{contact.a.index, contact.b.index};
      const auto found = right.find(bodies);
      if (found == right.end() || !same_bits(found->second, contact.manifold)) note(bodies);
      if (found != right.end()) right.erase(found);
    }
    for (const auto& [bodies, manifold] : right) note(bodies);
  }

 private:
  using Bodies = std::pair<std::uint32_t, std::uint32_t>;

  /// One body against all behind it at a time, for all pairs would not fit into memory.
  std::map<Bodies, Manifold<float>> contacts_of_all_pairs() {
    std::map<Bodies, Manifold<float>> contacts;
    const auto count = static_cast<std::uint32_t>(placements_.size());
    for (std::uint32_t a = 0; a < count; ++a) {
      pairs_.clear();
      for (std::uint32_t b = a + 1; b < count; ++b) pairs_.push_back({a, b});
      manifolds_.resize(pairs_.size());
      kernel::collide_pairs(shapes_, placements_, pairs_, tie_bias_, manifolds_);
      for (std::size_t i = 0; i < pairs_.size(); ++i) {
        if (manifolds_[i].count > 0) contacts[{a, pairs_[i].b}] = manifolds_[i];
      }
    }
    return contacts;
  }

  PairCase pair(const Bodies& bodies) const {
    const auto body = [&](std::uint32_t i) {
      return Body{polygons_[placements_[i].shape], placements_[i].pose};
    };
    return {body(bodies.first), body(bodies.second)};
  }

  std::vector<ConvexPolygon<float>> polygons_;
  kernel::Shapes<float> shapes_;
  std::vector<kernel::Placement<float>> placements_;
  float tie_bias_;
  std::vector<kernel::BodyPair> pairs_;
  std::vector<Manifold<float>> manifolds_;
};

}  // namespace

AfreshCheck check_afresh(const Trajectory& trajectory, const scene::Settings& settings) {
  AfreshCheck check;
  const std::size_t bodies = trajectory.start.size();
  const std::size_t steps = trajectory.steps.size() + 1;  // and as they start
  const std::size_t affordable = kPairsMax / std::max<std::size_t>(1, bodies * (bodies - 1) / 2);
  if (affordable == 0) return check;
  const std::size_t every = (steps + affordable - 1) / affordable;
  ScenePlayer player(trajectory, settings);
  Afresh afresh(trajectory, settings.tie_bias);
  for (std::size_t step = 0; step < steps; ++step) {
    if (step > 0) {
      afresh.move(trajectory.steps[step - 1]);
      player.step(trajectory.steps[step - 1]);
    }
    const bool is_last_of_its_share = (steps - 1 - step) % every == 0;
    if (is_last_of_its_share) afresh.check(player.result().contacts, check);
  }
  return check;
}

}  // namespace manifuzz
