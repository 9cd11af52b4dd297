#include "measure/scene/scene_recycling.hpp"

#include "measure/scene/scene_player.hpp"
#include "own_colliders/kernel.hpp"

namespace manifuzz {
namespace {

/// Judging one takes about a hundred times as long as colliding it.
constexpr std::size_t kJudged = 2000;

/// Measures one in so many contacts, whatever the step.
class Sampler {
 public:
  Sampler(const Trajectory& trajectory, std::size_t contacts)
      : declaration_(make_batch(0).declaration),
        every_(1 + contacts * trajectory.steps.size() / kJudged),
        bodies_(trajectory.bodies()) {}

  void add(std::span<const BodyMove> moves, std::span<const scene::Contact> contacts) {
    move_bodies(moves, bodies_);
    for (const scene::Contact& contact : contacts) {
      if (seen_++ % every_ != 0) continue;
      Referee referee({bodies_[contact.a.index], bodies_[contact.b.index]});
      const Answer answer = manifold_cast<double>(contact.manifold);
      errors_.add(seen_, referee.measure(declaration_, referee.completed(declaration_, answer)));
    }
  }

  ErrorStatistics statistics() const { return errors_.statistics(); }

 private:
  Declaration declaration_;
  std::size_t every_;
  std::size_t seen_ = 0;
  std::vector<Body> bodies_;
  ErrorCollector errors_;
};

/// How many pairs were collided, and how good the contacts are.
std::pair<std::size_t, ErrorStatistics> recycled_at(const Trajectory& trajectory, float motion) {
  ScenePlayer player(trajectory, {.recycled_motion = motion});
  Sampler sampler(trajectory, player.result().contacts.size());
  std::size_t collided = 0;
  for (const auto& moves : trajectory.steps) {
    const scene::StepResult& result = player.step(moves);
    sampler.add(moves, result.contacts);
    collided += result.counts.pairs.collided;
  }
  return {collided, sampler.statistics()};
}

}  // namespace

std::vector<RecyclingRun> run_recycling(const Trajectory& trajectory) {
  std::vector<RecyclingRun> runs;
  std::size_t strict = 0;
  for (const float motion : kRecyclingMotions) {
    const auto [collided, errors] = recycled_at(trajectory, motion);
    if (motion == 0) strict = collided;
    const double kept =
        strict == 0 ? 1 : static_cast<double>(collided) / static_cast<double>(strict);
    runs.push_back({motion, 1 - kept, errors});
  }
  return runs;
}

}  // namespace manifuzz
