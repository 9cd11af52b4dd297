#pragma once

#include "measure/scene/trajectory.hpp"
#include "measure/stress/step_tally.hpp"

namespace manifuzz {

/// What recycling makes of a scene: what it skips, and what that does to the contacts.
struct RecyclingRun {
  float motion = 0;  ///< scene::Settings::recycled_motion; 0 is strict
  double skipped =
      0;             ///< how many fewer pairs are collided than in strict mode, as a share of those
  StepTally judged;  ///< of a sample of the contacts, spread over all steps
};

/// The motions of a curve: lengths, in scenes of bodies about 1 wide. Strict mode comes first.
inline constexpr std::array<float, 8> kRecyclingMotions{0,     0.0003F, 0.001F, 0.003F,
                                                        0.01F, 0.03F,   0.1F,   0.3F};

/// A run a motion.
std::vector<RecyclingRun> run_recycling(const Trajectory& trajectory);

}  // namespace manifuzz
