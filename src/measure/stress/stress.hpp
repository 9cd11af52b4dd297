#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "collider/collider.hpp"
#include "generating/sweep.hpp"
#include "measure/referee.hpp"
#include "process/interruption.hpp"

namespace manifuzz {

/// Changes from one frame of a walk to the next that the truth does not ask for.
struct Changes {
  std::uint64_t with_margin = 0;   ///< what decides was beyond the bound in both frames
  std::uint64_t within_bound = 0;  ///< rounding may decide
  std::uint64_t first = 0;         ///< the frame of the first with margin

  friend bool operator==(const Changes&, const Changes&) = default;
};

struct WalkChanges {
  std::uint64_t touching = 0;  ///< frames, by the truth
  Changes flickers;            ///< of the reference
  Changes jumps;               ///< of a point, farther than the truth's and both bounds
  Changes features;            ///< or the number of points

  friend bool operator==(const WalkChanges&, const WalkChanges&) = default;
};

/// Counts one collider's changes through the frames of a walk. What the truth itself does is no
/// fault: only what changes while the truth's own choice does not, is counted.
class WalkChangeCounter {
 public:
  /// The next frame; `answer` as `Referee::completed` gives it.
  void add(std::uint64_t frame, Referee& referee, const Declaration& declaration,
           const Answer& answer);
  const WalkChanges& changes() const { return changes_; }

 private:
  /// What is kept of a frame in which there was a contact, by the collider and by the truth.
  struct Frame {
    Manifold<double> manifold;
    Manifold<double> truth;
    std::optional<Side> reference{};      ///< where it is decided
    std::optional<exact::FaceOf> only{};  ///< the only right reference face, with the only right...
    int incident = 0;                     ///< ...incident edge
    double bound = 0;                     ///< of the points' positions
  };
  static Frame frame_of(const Manifold<double>& manifold, const Manifold<double>& truth,
                        const Admissible& right);
  void compare(std::uint64_t frame, const Frame& now);

  WalkChanges changes_;
  std::optional<Frame> before_;
};

/// One collider in one step of a sweep, or in a walk: plain data that lies in shared memory.
struct StepStatistics : ErrorStatistics {
  WalkChanges walk;

  friend bool operator==(const StepStatistics&, const StepStatistics&) = default;
};

/// More than one well-posed case in so many wrong breaks a step.
inline constexpr std::uint64_t kWrongEvery = 10'000;

/// Whether a collider has broken: the 99.9th percentile of an error of depth, position or normal
/// exceeds 1% of the size (0.01 of the normal), or one well-posed case in 10^4, rounded up to one
/// case, is wrong.
bool is_broken(const ErrorStatistics& step);

/// The first step that is broken; none where none is.
std::optional<std::size_t> breaking_step(std::span<const StepStatistics> steps);

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

  std::string_view name() const { return walk != nullptr ? walk->name : sweep->name; }
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
  /// The statistics of a walk; nullptr where it was not measured.
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

/// Adds the sweeps and walks of these names to a plan, each once; all for no name. Throws UserError
/// that names `option` and what there is.
void choose_sweeps(const std::vector<std::string>& names, std::string_view option,
                   StressPlan& plan);

/// The ideal, then each of these; of each that takes a tie bias, a variant for the walks as well.
/// Throws UserError where two have one name, or where there are more than kSubjectsMax.
std::vector<StressSubject> with_variants(const std::vector<StressSubject>& chosen);

/// What is stored of a sweep or a walk and one subject.
struct StoredPoint {
  Unit unit;  ///< the step that breaks, the number of steps: none does; or the walk
  std::size_t subject = 0;
  std::uint64_t faults = 0;  ///< of the walk
};

/// What a file stores of the sweeps, walks and subjects of a plan. Throws UserError where it
/// stores nothing of them, or what no run writes, or what was measured on other terms.
std::vector<StoredPoint> read_breaking_points(const std::string& path, const StressPlan& plan);

struct Comparison {
  /// A line for each breaking point that lies before the stored one, and each walk with more
  /// faults.
  std::vector<std::string> worse;
  /// A line for each sweep and walk that was interrupted before it could be compared.
  std::vector<std::string> not_compared;
};

Comparison compare(const StressPlan& plan, const StressResult& result,
                   const std::vector<StoredPoint>& stored);

/// What is stored in a file, for a run of this plan to be added; nothing where there is no file.
/// Throws UserError where it is none of such, or on other terms.
nlohmann::ordered_json stored_before(const std::string& path, const StressPlan& plan);

/// `before`, and over it what a whole run found of each sweep and collider, where it breaks, and of
/// each walk, its faults; with the terms that must be the same for a fair comparison.
nlohmann::ordered_json breaking_points_json(const StressPlan& plan, const StressResult& result,
                                            nlohmann::ordered_json before);

/// Writes the worst of a run to a corpus, a file a sweep and collider, over those of runs before
/// that are no worse:
/// - where a collider is wrong, by the judge too: the case on which it is farthest off, shrunk, in
///   the folder of its verdict;
/// - of `clip` otherwise, against Box2D or, where that leaves nothing to decide, clip64: the case
///   of its largest error, as a case on which it must stay right.
/// `on_file` is told of each before it is shrunk, `on_kept` of each file of a run before that shows
/// a worse case. Throws UserError where one cannot be written, and Interrupted.
void save_worst(const StressPlan& plan, const StressResult& result,
                const std::filesystem::path& corpus, Interruption& interruption,
                const std::function<void(const std::string& name)>& on_file,
                const std::function<void(const std::filesystem::path& file)>& on_kept);

/// Whether this processor can be told to, as far as is known here.
bool can_flush_to_zero();

/// As long as it lives, and where it is wanted, this thread takes subnormal numbers for zero, and
/// makes none: what many an engine asks of the processor.
class FlushToZero {
 public:
  explicit FlushToZero(bool wanted);
  ~FlushToZero();
  FlushToZero& operator=(FlushToZero&&) = delete;  // neither moved nor copied

 private:
  bool wanted_;
  unsigned before_ = 0;
};

/// After so many lost cases a collider has lost the rest of its unit: crashes are slow.
inline constexpr std::size_t kLostMax = 20;

/// The cases at which a subject died or hung.
struct LostCases {
  std::array<std::uint64_t, kLostMax> cases{};
  std::size_t count = 0;
  /// It is not asked from here on, having died too often.
  std::uint64_t given_up_from = std::numeric_limits<std::uint64_t>::max();

  /// One that dies of what it answered before is not asked again: reruns would have no end.
  void add(std::uint64_t index);
  /// Whether the subject is not to be asked: it died of this case, or of too many before it.
  bool has(std::uint64_t index) const;
};

/// Nobody is being asked.
inline constexpr int kNobody = -1;

/// What is being done about a unit, in memory that a job shares with its parent.
struct UnitState {
  std::atomic<std::uint64_t> index{0};         ///< the case at work
  std::atomic<int> subject{kNobody};           ///< who is being asked
  std::atomic<std::uint64_t> progress{0};      ///< moves while anything does
  std::array<LostCases, kSubjectsMax> lost{};  ///< by subject
};

/// Runs a unit from its first case on, and tells `on_cases` of every block that is done; `tallies`
/// are the subjects'. False where `go_on` said no before its end.
bool run_unit(const StressPlan& plan, const Unit& unit, UnitState& state,
              const std::function<bool()>& go_on,
              const std::function<void(std::uint64_t)>& on_cases,
              std::span<StepStatistics> tallies);

}  // namespace manifuzz
