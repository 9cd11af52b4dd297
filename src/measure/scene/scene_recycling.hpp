#pragma once

#include <string>
#include <vector>

#include "measure/error_statistics.hpp"
#include "measure/scene/trajectory.hpp"

namespace manifuzz {

/// What recycling up to a motion skips in a scene, and how good the contacts are then.
struct RecyclingRun {
  float motion = 0;        ///< scene::Settings::recycled_motion; 0 is strict
  double skipped = 0;      ///< the share of strict mode's collisions that it spares
  ErrorStatistics errors;  ///< of a sample of the contacts, spread over all steps
};

/// The same of one scene, a run a motion.
struct RecyclingCurve {
  std::string scene;
  std::size_t bodies = 0;
  std::vector<RecyclingRun> runs;
};

/// The motions of a curve: lengths, in scenes of bodies about 1 wide. Strict mode comes first.
inline constexpr std::array<float, 8> kRecyclingMotions{0,     0.0003F, 0.001F, 0.003F,
                                                        0.01F, 0.03F,   0.1F,   0.3F};

/// A run a motion.
std::vector<RecyclingRun> run_recycling(const Trajectory& trajectory);

}  // namespace manifuzz
