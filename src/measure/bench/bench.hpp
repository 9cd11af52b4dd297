#pragma once

#include <array>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "collider/collider.hpp"
#include "generating/regime.hpp"
#include "measure/referee.hpp"

namespace manifuzz {

/// Which cases are timed together.
struct WorkloadSpec {
  const Regime* regime = nullptr;
  std::optional<int> vertices;  ///< of both polygons; mixed where there is none
  double touching = 0.5;        ///< the share of pairs that touch
  std::size_t pairs = 1024;     ///< as many as are gone through before the first comes again
  /// By which share of the size those that touch overlap: from the first to below the second.
  std::array<double, 2> overlap{0, std::numeric_limits<double>::infinity()};
};

/// The regime `generic`, mixed counts, half touching, in the second cache.
WorkloadSpec usual_workload();

/// The usual workload first; then, each by itself, other counts, shares of touching pairs and
/// numbers of pairs, and other regimes.
std::vector<WorkloadSpec> all_workloads(std::span<const Regime* const> regimes);

/// The regime's first cases that fit, polygons without radius, touching and separated ones mixed;
/// of round shapes those that `takes` says. None where the regime has hardly any that fit.
std::optional<std::vector<PairCase>> draw_workload(
    const WorkloadSpec& spec, std::uint64_t seed,
    const std::function<bool(const PairCase&)>& takes = {});

/// Something that is timed: one way to ask one collider.
struct BenchSubject {
  std::string name;
  std::string query = "manifold";  ///< or touches, separation
  std::string input = "pair";      ///< or packed, indices
  std::string target{};  ///< the instruction set that the kernels are to use; empty: it asks none
  /// Lays pairs out as the collider's users hold them, and gives what goes through all of them
  /// once. What it needs lives in the function.
  std::function<std::function<void()>(std::span<const PairCase>)> prepare{};
  /// For the errors; empty where it gives no manifolds.
  std::function<Collider()> collider{};
  bool is_library = false;  ///< asked through manifuzz_collider.h, as kInterface is
};

/// The subject that asks a library that does nothing.
inline constexpr std::string_view kInterface = "interface";

/// The subject to whose time every other's is a ratio.
inline constexpr std::string_view kRatioBase = "box2d";

struct TimingOptions {
  int repetitions = 9;
  double repetition_seconds = 0.02;
};

struct Timing {
  double ns_per_pair = 0;         ///< the median of the repetitions
  double speedup_over_box2d = 0;  ///< the median of their ratios, each to Box2D's of its number
  /// For a library: the median of the differences to kInterface's repetitions.
  std::optional<double> ns_without_interface = {};
};

/// Times the subjects over the same pairs, on Google Benchmark, their repetitions in random order;
/// the kernels then use the widest instruction set again. One of them is the ratios' base.
std::vector<Timing> time_subjects(const std::vector<BenchSubject>& subjects,
                                  std::span<const PairCase> pairs, const TimingOptions& options);

/// What this repository offers, the kernels once for every instruction set of this machine; and
/// the one-point answer of the separating axis alone, which is the cheapest that is right in depth.
/// Beside the kernels, their limits.
std::vector<BenchSubject> own_subjects();

/// What a collider is off by, as the referee measures it.
struct BenchErrors {
  ErrorSpreads of_extent;  ///< of all contacts, in units of 2^-24 of the extent; normals of 2^-24
  std::map<std::uint64_t, PairCase> worst;  ///< the spreads' worst cases, by their indices
  std::uint64_t missed = 0;
  std::uint64_t phantom = 0;
  std::uint64_t cases = 0;  ///< answered
};

/// The errors of each subject that gives manifolds, by name; how it is asked does not matter.
std::map<std::string, BenchErrors> measure_errors(const std::vector<BenchSubject>& subjects,
                                                  std::span<const PairCase> pairs);

/// What no kernel can beat, timed beside them, for one instruction set: the arithmetic of the pairs
/// in full lanes, all of it independent, by either way to know separations; and the bytes of packed
/// pairs and their manifolds, read and written once.
std::vector<BenchSubject> limits(const std::string& target);

/// What the separation of a face is computed from.
enum class Opposing {
  every_corner,  ///< all corners of the other polygon: the deepest is not known
  support        ///< the deepest corner alone, as if a step before had told which it is
};

/// Additions, subtractions, multiplications, quotients and comparisons that the manifold of a pair
/// takes, from poses to depths; `touches` says whether there is anything to clip.
int operations(int count_a, int count_b, bool touches, Opposing opposing);

/// One subject over one workload.
struct BenchRow {
  BenchSubject subject;
  std::size_t workload = 0;  ///< its index
  WorkloadSpec spec;
  Timing timing;
  std::optional<BenchErrors> errors;  ///< none where it gives no manifolds
};

struct BenchOptions {
  std::uint64_t seed = 1;
  std::size_t judged = 20'000;  ///< cases a workload whose errors are measured
  TimingOptions timing;
};

/// Fewer cases and shorter repetitions.
BenchOptions quick_bench();

/// Every subject over every workload that its regime has cases for; of round shapes those subjects
/// that take all that Box2D takes. `on_workload` is told which one comes next.
std::vector<BenchRow> run_bench(const std::vector<BenchSubject>& subjects,
                                const std::vector<WorkloadSpec>& workloads,
                                const BenchOptions& options,
                                const std::function<void(std::size_t)>& on_workload);

}  // namespace manifuzz
