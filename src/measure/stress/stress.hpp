#pragma once

#include <functional>
#include <string>
#include <vector>

#include "collider/collider.hpp"
#include "generating/sweep.hpp"
#include "generating/walk.hpp"
#include "measure/stress/step_statistics.hpp"
#include "process/interruption.hpp"

namespace manifuzz {

/// A collider under stress, as it is called here.
struct StressSubject {
  std::string name;
  Collider collider;
  bool walks_only = false;  ///< a variant that only walks have a use for
  bool is_ours = false;     ///< of this repository
};

/// The line that no float collider can stay below: the truth, its figures rounded once.
inline constexpr std::string_view kIdealName = "ideal";
StressSubject ideal_subject();

/// The tie bias of the variants that walk with one: Box2D's.
inline constexpr double kWalkBias = 0.0005;

inline constexpr std::size_t kSubjectsMax = 32;

struct StressPlan {
  std::vector<const Sweep*> sweeps;
  std::vector<const Walk*> walks;
  std::vector<StressSubject> subjects;  ///< at most kSubjectsMax
  std::uint64_t seed = 1;
  std::uint64_t cases = 100'000;     ///< a step
  std::uint64_t frames = 1'000'000;  ///< a walk
  int jobs = 1;
  bool flush_to_zero = false;  ///< while a collider in this process is asked
};

/// What a job does in one go: a step of a sweep, or a walk.
struct Unit {
  const Sweep* sweep = nullptr;
  std::size_t step = 0;
  const Walk* walk = nullptr;
};

std::vector<Unit> units_of(const StressPlan& plan);
std::uint64_t cases_of(const StressPlan& plan, const Unit& unit);
/// Case `index` of a unit.
PairCase case_of(const StressPlan& plan, const Unit& unit, std::uint64_t index);

struct StressResult {
  std::vector<Unit> units;                           ///< that were measured, in the plan's order
  std::vector<std::vector<StepStatistics>> tallies;  ///< of each, by subject
  bool interrupted = false;
  double seconds = 0;

  /// The steps of a sweep, as far as they were measured without a gap.
  std::vector<StepStatistics> steps(const Sweep& sweep, std::size_t subject) const;
  /// Of a walk; nullptr where it was not measured.
  const StepStatistics* walk(const Walk& walk, std::size_t subject) const;
};

struct StressProgress {
  std::uint64_t done = 0;
  std::uint64_t total = 0;  ///< cases
  double seconds = 0;
};

/// Measures every unit of the plan, in as many child processes as it has jobs. A collider that
/// dies or hangs has lost the case; one that does so again and again has lost the rest of the unit.
/// What comes out depends on the plan alone, whatever the jobs. `on_progress` runs a few
/// times a second.
StressResult run_stress(const StressPlan& plan, Interruption& interruption,
                        const std::function<void(const StressProgress&)>& on_progress);

}  // namespace manifuzz
