#include "measure/scene_recycling.hpp"

#include "kernel/collider.hpp"
#include "measure/scene_player.hpp"

namespace manifuzz {
namespace {

/// Judging one takes about a hundred times as long as colliding it.
constexpr std::size_t kJudged = 2000;

/// Every so many contacts one is judged, whatever the step.
class Sampler {
 public:
  Sampler(const Trajectory& trajectory, std::size_t contacts)
      : declaration_(make_batch(0).declaration),
        every_(1 + contacts * trajectory.steps.size() / kJudged) {
    for (std::size_t i = 0; i < trajectory.start.size(); ++i) bodies_.push_back(trajectory.body(i));
  }

  void move(std::span<const BodyMove> moves) {
    for (const BodyMove& move : moves) bodies_[move.body].pose = move.pose;
  }

  void look_at(std::span<const scene::Contact> contacts) {
    for (const scene::Contact& contact : contacts) {
      if (seen_++ % every_ != 0) continue;
      Referee referee({bodies_[contact.a.index], bodies_[contact.b.index]});
      const Answer heard = referee.heard(declaration_, manifold_cast<double>(contact.manifold));
      judged_.add(seen_, referee.measure(declaration_, heard));
    }
  }

  StepTally tally() const { return judged_.tally(); }

 private:
  Declaration declaration_;
  std::size_t every_;
  std::size_t seen_ = 0;
  std::vector<Body> bodies_;
  StepCollector judged_;
};

}  // namespace

RecyclingRun run_recycling(const Trajectory& trajectory, float motion) {
  ScenePlayer player(trajectory, {.recycled_motion = motion});
  Sampler sampler(trajectory, player.result().contacts.size());
  scene::PairCounts sum;
  for (const auto& moves : trajectory.steps) {
    const scene::StepResult& result = player.step(moves);
    sampler.move(moves);
    sampler.look_at(result.contacts);
    sum.recycled += result.counts.pairs.recycled;
    sum.collided += result.counts.pairs.collided;
  }
  const auto all = static_cast<double>(std::max<std::size_t>(1, sum.recycled + sum.collided));
  return {motion, static_cast<double>(sum.recycled) / all, sampler.tally()};
}

}  // namespace manifuzz
